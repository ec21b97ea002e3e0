#include "services/coordinator/server/webhooks/http_post.h"

#include "services/coordinator/server/webhooks/public_address.h"
#include "services/coordinator/store/http/http_client.h"

namespace slicefarm::coordinator {

absl::StatusOr<int> HttpPost(const std::string& url, const std::string& body,
                             const HttpPostOptions& options) {
  // Each post has a client of its own, so that no connection with other rules is reused.
  HttpClient client({.connect = options.timeout,
                     .total = options.timeout,
                     .may_reach = options.private_addresses ? nullptr : &IsPublicAddress});
  const BodySource source{std::ssize(body), [&](int64_t offset, int64_t limit) {
                            return absl::StatusOr<std::string>(body.substr(offset, limit));
                          }};
  HttpRequest request{"POST", url, options.headers, &source};
  request.headers.emplace_back("Content-Type: application/json");
  const auto answer = client.Do(request);
  if (absl::IsPermissionDenied(answer.status()))
    return absl::PermissionDeniedError("the address is not in the public Internet");
  if (!answer.ok()) return answer.status();
  return answer->status;
}

}  // namespace slicefarm::coordinator
