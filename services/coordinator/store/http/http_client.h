#pragma once

#include <sys/socket.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"

namespace slicefarm::coordinator {

/// Bytes that are sent, read as they are needed, and again if they must be sent again.
struct BodySource {
  using Read = std::function<absl::StatusOr<std::string>(int64_t offset, int64_t limit)>;

  int64_t size = 0;
  Read read;  ///< up to `limit` bytes from `offset` on; fewer only at the end
};

/// Signs a request for Amazon's S3 API: AWS Signature Version 4, over all headers of the request,
/// `x-amz-content-sha256` among them.
struct AwsSignature {
  std::string region;
  std::string access_key;
  std::string secret_key;
};

struct HttpRequest {
  std::string method;  ///< GET, HEAD, PUT, POST or DELETE
  std::string url;
  std::vector<std::string> headers = {};  ///< "Name: value"
  const BodySource* body = nullptr;       ///< of PUT and POST
  int64_t most_bytes = 64 << 10;          ///< of the answer; the rest is cut off
  CancelToken cancel = {};                ///< looked at once a second, and when bytes move
  std::optional<AwsSignature> signature = {};
};

struct HttpAnswer {
  int status = 0;
  std::string body;
  int64_t content_length = 0;  ///< as the header says, also of HEAD
  bool is_cut = false;         ///< the body was longer than the request allows
};

struct HttpClientOptions {
  std::string ca_file = {};  ///< of those who sign the servers' certificates; empty: the system's
  std::chrono::milliseconds connect{5'000};
  std::chrono::seconds stall{30};      ///< without so much as a KiB a second in all that time
  std::chrono::milliseconds total{0};  ///< for a whole request; 0: no limit
  /// Tells if an address may be connected to that a host's name led to; null: all may.
  bool (*may_reach)(const sockaddr& address) = nullptr;
};

/// Requests over connections that are kept, as many as there are requests at a time. Follows no
/// redirect and uses no proxy. Thread-safe.
class HttpClient {
 public:
  explicit HttpClient(HttpClientOptions options) : options_(std::move(options)) {}
  ~HttpClient();
  HttpClient(const HttpClient&) = delete;
  HttpClient& operator=(const HttpClient&) = delete;

  /// Errors: those of the body; CANCELLED; PermissionDenied for an address that may not be reached;
  /// Unavailable with the cause if there was no whole answer.
  absl::StatusOr<HttpAnswer> Do(const HttpRequest& request);

 private:
  void* Take();
  void GiveBack(void* handle);

  const HttpClientOptions options_;
  std::mutex mutex_;
  std::vector<void*> idle_;  ///< handles of libcurl, each with its connections
};

}  // namespace slicefarm::coordinator
