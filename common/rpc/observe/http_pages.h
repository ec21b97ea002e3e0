#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"

struct MHD_Daemon;

namespace slicefarm::rpc {

/// Page for people or for Prometheus. Its content is computed for each request.
struct HttpPage {
  std::string path;  ///< for example "/metrics"
  std::string mime;
  std::function<std::string()> content;  ///< called on the thread of the pages, one call at a time
};

/// HTTP server (libmicrohttpd) that only answers GET and HEAD requests for its pages. A connection
/// without a complete request is closed after 10 s and delays no other connection. For the internal
/// network: there is no TLS, and any client may read the pages.
class HttpPages {
 public:
  /// Starts to serve on `address` (host:port, port 0: any). Errors: Unavailable if it cannot listen
  /// on this address.
  static absl::StatusOr<std::unique_ptr<HttpPages>> Serve(const std::string& address,
                                                          std::vector<HttpPage> pages);

  /// Waits until a page that is being sent is complete.
  ~HttpPages();
  HttpPages(const HttpPages&) = delete;
  HttpPages& operator=(const HttpPages&) = delete;

  int port() const;

 private:
  explicit HttpPages(std::vector<HttpPage> pages) : pages_(std::move(pages)) {}

  const std::vector<HttpPage> pages_;
  MHD_Daemon* server_ = nullptr;  // library's handle, made by MHD_start_daemon
};

}  // namespace slicefarm::rpc
