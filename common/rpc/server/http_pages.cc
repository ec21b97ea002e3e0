#include "common/rpc/server/http_pages.h"

#include <civetweb.h>

#include <array>
#include <string_view>
#include <utility>

#include "common/base/error.h"

namespace slicefarm::rpc {
namespace {

constexpr int kOk = 200;
constexpr int kMethodNotAllowed = 405;

int Answer(mg_connection* connection, void* page_data) {
  const auto& page = *static_cast<const HttpPage*>(page_data);
  const std::string_view method = mg_get_request_info(connection)->request_method;
  if (method != "GET" && method != "HEAD") {
    mg_send_http_error(connection, kMethodNotAllowed, "%s", "only GET and HEAD");
    return kMethodNotAllowed;
  }
  const std::string content = page.content();
  mg_send_http_ok(connection, page.mime.c_str(), static_cast<long long>(content.size()));
  if (method == "GET") mg_write(connection, content.data(), content.size());
  return kOk;
}

/// civetweb's own words would stand between the JSON lines on stderr.
int Silence(const mg_connection* /*connection*/, const char* /*message*/) { return 1; }

}  // namespace

absl::StatusOr<std::unique_ptr<HttpPages>> HttpPages::Serve(const std::string& address,
                                                            std::vector<HttpPage> pages) {
  std::unique_ptr<HttpPages> served(new HttpPages(std::move(pages)));
  mg_callbacks callbacks = {};
  callbacks.log_message = Silence;
  // A reader that stands still holds a thread for a while; the others go on.
  const std::array<const char*, 7> options = {
      "listening_ports",    address.c_str(), "num_threads", "4",
      "request_timeout_ms", "5000",          nullptr};
  served->server_ = mg_start(&callbacks, nullptr, const_cast<const char**>(options.data()));
  if (served->server_ == nullptr) {
    return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                     "cannot serve pages on " + address, {{"address", address}});
  }
  for (const HttpPage& page : served->pages_) {
    // "$": this path and none below it. The page is only read.
    mg_set_request_handler(served->server_, (page.path + "$").c_str(), Answer,
                           const_cast<HttpPage*>(&page));
  }
  return served;
}

HttpPages::~HttpPages() {
  if (server_ != nullptr) mg_stop(server_);
}

int HttpPages::port() const {
  mg_server_port port = {};
  mg_get_server_ports(server_, 1, &port);
  return port.port;
}

}  // namespace slicefarm::rpc
