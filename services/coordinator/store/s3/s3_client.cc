#include "services/coordinator/store/s3/s3_client.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/cancel_scope.h"
#include "common/base/sha256.h"
#include "common/base/stoppable_sleep.h"

namespace slicefarm::coordinator {
namespace {

constexpr std::string_view kProbeKey = "slicefarm-probe";

/// Returns the text between <Code> and </Code>. The rest of an error's XML is not needed.
std::string_view CodeOf(std::string_view body) {
  const size_t begin = body.find("<Code>");
  if (begin == std::string_view::npos) return {};
  body.remove_prefix(begin + 6);
  return body.substr(0, body.find('<'));
}

/// Returns true if a repeated request may get a better answer after a moment.
bool MayGoBetter(int status, std::string_view code) {
  if (status == 400) {  // the bytes changed in transfer, or some are missing
    for (const char* each :
         {"XAmzContentSHA256Mismatch", "BadDigest", "IncompleteBody", "RequestTimeout"})
      if (code == each) return true;
  }
  return status == 409 || status == 429 || status >= 500;
}

absl::Status ErrorOf(const HttpAnswer& answer, const std::string& method) {
  const std::string_view code = CodeOf(answer.body);
  const std::string text =
      fmt::format("the bucket answers {} with {} {}", method, answer.status, code);
  if (answer.status == 404 && code != "NoSuchBucket") return absl::NotFoundError(text);
  if (answer.status == 416) return absl::NotFoundError(text);  // the object is shorter
  if (answer.status == 403 || answer.status == 401 || code == "NoSuchBucket")
    return absl::PermissionDeniedError(text);
  return absl::UnavailableError(text);
}

const std::string& DigestOfNothing() {
  static const std::string digest = Sha256Hex("");
  return digest;
}

}  // namespace

struct S3Client::Wanted {
  std::string method;
  std::string key;
  std::string range = {};            ///< range of GET
  const BodySource* body = nullptr;  ///< body of PUT
  std::string sha256 = DigestOfNothing();
  int64_t most_bytes = 64 << 10;
};

absl::StatusOr<HttpAnswer> S3Client::AskOnce(const Wanted& wanted, const CancelToken& cancel,
                                             bool& again) {
  const auto credentials = options_.credentials();
  HttpRequest http{wanted.method, options_.address.UrlOf(wanted.key)};
  http.headers = {absl::StrCat("x-amz-content-sha256: ", wanted.sha256)};
  if (!wanted.range.empty()) http.headers.push_back(absl::StrCat("range: ", wanted.range));
  if (!credentials->session_token.empty())
    http.headers.push_back(absl::StrCat("x-amz-security-token: ", credentials->session_token));
  http.signature = {options_.region, credentials->access_key, credentials->secret_key};
  http.body = wanted.body;
  http.most_bytes = wanted.most_bytes;
  http.cancel = cancel;
  auto answer = http_.Do(http);
  if (answer.ok() && answer->is_cut)
    answer = absl::UnavailableError("the answer is longer than the requested range");
  again = absl::IsUnavailable(answer.status());
  if (!answer.ok() || answer->status / 100 == 2) return answer;
  again = MayGoBetter(answer->status, CodeOf(answer->body));
  return ErrorOf(*answer, wanted.method);
}

absl::StatusOr<HttpAnswer> S3Client::Ask(const Wanted& wanted) {
  const CancelToken cancel = CancelScope::Current();
  std::chrono::milliseconds pause = options_.first_pause;
  for (int left = options_.tries;;) {
    bool again = false;
    auto answer = AskOnce(wanted, cancel, again);
    if (answer.ok() || !again || --left == 0) return answer;
    if (absl::Status wanted_still = SleepUnlessCancelled(cancel, pause); !wanted_still.ok())
      return wanted_still;
    pause *= 2;
  }
}

absl::Status S3Client::Put(const std::string& key, const std::string& sha256,
                           const BodySource& body) {
  return Ask({.method = "PUT", .key = key, .body = &body, .sha256 = sha256}).status();
}

absl::StatusOr<std::string> S3Client::Get(const std::string& key, int64_t offset, int64_t count) {
  auto answer = Ask({.method = "GET",
                     .key = key,
                     .range = absl::StrCat("bytes=", offset, "-", offset + count - 1),
                     .most_bytes = std::max<int64_t>(count, 64 << 10)});
  if (!answer.ok()) return answer.status();
  // A server without support for ranges sends the whole object, which is correct only if offset is
  // 0.
  if ((answer->status != 206 && offset > 0) || std::ssize(answer->body) > count)
    return absl::UnavailableError("the bucket returned other bytes than the requested ones");
  return std::move(answer->body);
}

absl::StatusOr<int64_t> S3Client::Size(const std::string& key) {
  const auto answer = Ask({.method = "HEAD", .key = key});
  if (!answer.ok()) return answer.status();
  return answer->content_length;
}

absl::Status S3Client::Delete(const std::string& key) {
  const absl::Status deleted = Ask({.method = "DELETE", .key = key}).status();
  return absl::IsNotFound(deleted) ? absl::OkStatus() : deleted;
}

absl::Status S3Client::Probe() {
  const std::string text = "slicefarm keeps its blobs here\n";
  const BodySource body{std::ssize(text), [&](int64_t offset, int64_t limit) {
                          return absl::StatusOr<std::string>(text.substr(offset, limit));
                        }};
  const std::string key(kProbeKey);
  if (absl::Status put = Put(key, Sha256Hex(text), body); !put.ok()) return put;
  const auto got = Get(key, 0, std::ssize(text));
  if (!got.ok()) return got.status();
  if (*got == text) return absl::OkStatus();
  return absl::UnavailableError("the bucket stored other bytes than it was given");
}

}  // namespace slicefarm::coordinator
