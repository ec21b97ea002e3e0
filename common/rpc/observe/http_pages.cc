#include "common/rpc/observe/http_pages.h"

#include <microhttpd.h>

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

#include "common/base/error.h"
#include "common/rpc/address/socket_address.h"

namespace slicefarm::rpc {
namespace {

constexpr unsigned kMaxConnections = 1000;
constexpr unsigned kIdleS = 10;
constexpr size_t kBytesOfAConnection = 8192;

struct EndResponse {
  void operator()(MHD_Response* response) const { MHD_destroy_response(response); }
};
using Response = std::unique_ptr<MHD_Response, EndResponse>;

/// Returns a response with a copy of the text.
Response ResponseOf(const std::string& text, const std::string& mime) {
  Response response(MHD_create_response_from_buffer(text.size(), const_cast<char*>(text.data()),
                                                    MHD_RESPMEM_MUST_COPY));
  MHD_add_response_header(response.get(), MHD_HTTP_HEADER_CONTENT_TYPE, mime.c_str());
  MHD_add_response_header(response.get(), MHD_HTTP_HEADER_CONNECTION, "close");
  return response;
}

MHD_Result Refuse(MHD_Connection* connection, unsigned code, const std::string& why) {
  return MHD_queue_response(connection, code, ResponseOf(why + "\n", "text/plain").get());
}

/// Answers a request. It is called once when the headers have arrived, and again when the whole
/// request has arrived.
MHD_Result Answer(void* pages, MHD_Connection* connection, const char* url, const char* method,
                  const char* /*version*/, const char* /*upload*/, size_t* upload_size,
                  void** begun) {
  if (*begun == nullptr) {
    *begun = connection;  // any value except null
    return MHD_YES;
  }
  if (std::exchange(*upload_size, 0) > 0) return MHD_YES;  // ignores the body of the request
  const std::string_view verb = method;
  if (verb != MHD_HTTP_METHOD_GET && verb != MHD_HTTP_METHOD_HEAD)
    return Refuse(connection, MHD_HTTP_METHOD_NOT_ALLOWED, "only GET and HEAD");
  const auto& known = *static_cast<const std::vector<HttpPage>*>(pages);
  const auto page = std::ranges::find(known, url, &HttpPage::path);
  if (page == known.end()) return Refuse(connection, MHD_HTTP_NOT_FOUND, "no such page");
  return MHD_queue_response(connection, MHD_HTTP_OK, ResponseOf(page->content(), page->mime).get());
}

}  // namespace

absl::StatusOr<std::unique_ptr<HttpPages>> HttpPages::Serve(const std::string& address,
                                                            std::vector<HttpPage> pages) {
  std::unique_ptr<HttpPages> served(new HttpPages(std::move(pages)));
  if (const SocketAddresses at = ResolveSocketAddress(address, AI_PASSIVE)) {
    unsigned flags = MHD_USE_EPOLL_INTERNAL_THREAD;
    if (at->ai_family == AF_INET6) flags |= MHD_USE_IPv6;
    // Uses one thread that never waits for a single connection, so incomplete requests do not delay
    // other requests.
    served->server_ = MHD_start_daemon(
        flags, 0, nullptr, nullptr, Answer, const_cast<std::vector<HttpPage>*>(&served->pages_),
        MHD_OPTION_SOCK_ADDR, at->ai_addr, MHD_OPTION_CONNECTION_LIMIT, kMaxConnections,
        MHD_OPTION_CONNECTION_TIMEOUT, kIdleS, MHD_OPTION_CONNECTION_MEMORY_LIMIT,
        kBytesOfAConnection, MHD_OPTION_END);
  }
  if (served->server_ == nullptr) {
    return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                     "cannot serve pages on " + address, {{"address", address}});
  }
  return served;
}

HttpPages::~HttpPages() {
  if (server_ != nullptr) MHD_stop_daemon(server_);
}

int HttpPages::port() const {
  return MHD_get_daemon_info(server_, MHD_DAEMON_INFO_BIND_PORT)->port;
}

}  // namespace slicefarm::rpc
