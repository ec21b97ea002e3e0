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

/// Body of a request. The client reads it in parts as needed, and again if the request is sent
/// again.
struct BodySource {
  using Read = std::function<absl::StatusOr<std::string>(int64_t offset, int64_t limit)>;

  int64_t size = 0;
  Read read;  ///< returns up to `limit` bytes from `offset` on; fewer only at the end
};

/// Keys for signing a request for Amazon's S3 API: AWS Signature Version 4 over all headers of the
/// request, including `x-amz-content-sha256`.
struct AwsSignature {
  std::string region;
  std::string access_key;
  std::string secret_key;
};

/// Request with its limits.
struct HttpRequest {
  std::string method;  ///< GET, HEAD, PUT, POST or DELETE
  std::string url;
  std::vector<std::string> headers = {};  ///< headers as "Name: value"
  const BodySource* body = nullptr;       ///< body of PUT and POST
  int64_t most_bytes = 64 << 10;          ///< largest body of the answer; a longer body is cut off
  /// Cancels the request. Checked once per second, and whenever bytes are transferred.
  CancelToken cancel = {};
  std::optional<AwsSignature> signature = {};
};

/// Answer of a server.
struct HttpAnswer {
  int status = 0;
  std::string body;
  int64_t content_length = 0;  ///< value of the header Content-Length, also for HEAD
  bool is_cut = false;         ///< true if the body exceeded the limit of the request
};

/// Options of an HttpClient.
struct HttpClientOptions {
  /// Certificates of the authorities that sign the servers' certificates; empty: the system's.
  std::string ca_file = {};
  std::chrono::milliseconds connect{5'000};
  std::chrono::seconds stall{30};      ///< a transfer ends after this time with less than 1 KiB/s
  std::chrono::milliseconds total{0};  ///< time limit of a whole request; 0: no limit
  /// Returns true if a connection to the address of a host is allowed. If null, all addresses are
  /// allowed.
  bool (*may_reach)(const sockaddr& address) = nullptr;
};

/// HTTP client that reuses its connections. Each concurrent request has its own connection. Follows
/// no redirect and uses no proxy. Thread-safe.
class HttpClient {
 public:
  explicit HttpClient(HttpClientOptions options) : options_(std::move(options)) {}
  ~HttpClient();
  HttpClient(const HttpClient&) = delete;
  HttpClient& operator=(const HttpClient&) = delete;

  /// Makes a request and returns its answer, with any HTTP status. Errors: errors of the body;
  /// CANCELLED; PermissionDenied for an address that is not allowed; Unavailable with the cause if
  /// there was no complete answer.
  absl::StatusOr<HttpAnswer> Do(const HttpRequest& request);

 private:
  void* Take();
  void GiveBack(void* handle);

  const HttpClientOptions options_;
  std::mutex mutex_;
  std::vector<void*> idle_;  ///< libcurl handles that are not in use, each with its connections
};

}  // namespace slicefarm::coordinator
