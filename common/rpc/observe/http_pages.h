#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"

struct MHD_Daemon;

namespace slicefarm::rpc {

/// A page that people or Prometheus ask for, made anew each time.
struct HttpPage {
  std::string path;  ///< "/metrics"
  std::string mime;
  std::function<std::string()> content;  ///< from the thread of the pages, one at a time
};

/// Serves some pages to GET and HEAD, and nothing else; by libmicrohttpd. A connection without a
/// request, or with half of one, is closed after 10 s and keeps nobody waiting. For the inner
/// network: without TLS, and anybody who comes may read.
class HttpPages {
 public:
  /// On `address` (host:port, port 0: any). Errors: Unavailable if it cannot listen there.
  static absl::StatusOr<std::unique_ptr<HttpPages>> Serve(const std::string& address,
                                                          std::vector<HttpPage> pages);

  /// Waits for a page that is being sent.
  ~HttpPages();
  HttpPages(const HttpPages&) = delete;
  HttpPages& operator=(const HttpPages&) = delete;

  int port() const;

 private:
  explicit HttpPages(std::vector<HttpPage> pages) : pages_(std::move(pages)) {}

  const std::vector<HttpPage> pages_;
  MHD_Daemon* server_ = nullptr;  // the library's handle: MHD_start_daemon makes it
};

}  // namespace slicefarm::rpc
