#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"

struct MHD_Daemon;

namespace slicefarm::rpc {

/// Page for people or for Prometheus. The server computes its content for each request.
struct HttpPage {
  std::string path;  ///< for example "/metrics"
  std::string mime;
  /// called on the server's thread, for one request at a time
  std::function<std::string()> content;
};

/// HTTP server (libmicrohttpd) that only answers GET and HEAD requests for its pages. It closes a
/// connection without a complete request after 10 s; until then, the connection does not delay
/// other connections. For the internal network: there is no TLS, and any client may read the pages.
class HttpPages {
 public:
  /// Starts to serve on `address` (host:port; port 0: any free port). Errors: Unavailable if the
  /// server cannot listen on this address.
  static absl::StatusOr<std::unique_ptr<HttpPages>> Serve(const std::string& address,
                                                          std::vector<HttpPage> pages);

  /// Stops the server. Waits until a page that is being sent is complete.
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
