#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/coordinator/store/http/http_client.h"
#include "services/coordinator/store/s3/s3_address.h"

namespace slicefarm::coordinator {

/// Keys for the access to a bucket.
struct S3Credentials {
  std::string access_key;
  std::string secret_key;
  std::string session_token = {};  ///< token of temporary keys; empty: none
};

/// Function that returns the current credentials.
using S3CredentialsNow = std::function<std::shared_ptr<const S3Credentials>()>;

/// Options of an S3Client.
struct S3Options {
  S3Address address;
  std::string region = "us-east-1";
  S3CredentialsNow credentials;
  HttpClientOptions http = {};
  int tries = 4;  ///< tries of a request after temporary errors
  /// First pause between tries; each further pause is twice as long.
  std::chrono::milliseconds first_pause{200};
};

/// Client for the objects of a bucket, by Amazon's S3 API or a compatible API. Thread-safe.
///
/// Errors of all functions: NotFound if the object does not exist; PermissionDenied if the bucket
/// refuses access; CANCELLED by the thread's CancelScope, also between two tries; Unavailable for
/// all other errors, after as many tries as the options allow.
class S3Client {
 public:
  explicit S3Client(S3Options options) : options_(std::move(options)), http_(options_.http) {}

  /// Writes an object. `sha256`: digest of the body. The server compares it with the bytes that it
  /// receives, so that no other bytes become the object. Errors: also errors of `body`.
  absl::Status Put(const std::string& key, const std::string& sha256, const BodySource& body);

  /// Returns `count` bytes from `offset` on; fewer if the object ends before. REQUIRES: count >= 1.
  absl::StatusOr<std::string> Get(const std::string& key, int64_t offset, int64_t count);

  /// Returns the size of an object.
  absl::StatusOr<int64_t> Size(const std::string& key);

  /// Deletes an object. Does nothing if it does not exist.
  absl::Status Delete(const std::string& key);

  /// Writes a small object and reads it, to detect a wrong address or secret.
  absl::Status Probe();

 private:
  struct Wanted;

  absl::StatusOr<HttpAnswer> Ask(const Wanted& wanted);
  absl::StatusOr<HttpAnswer> AskOnce(const Wanted& wanted, const CancelToken& cancel, bool& again);

  const S3Options options_;
  HttpClient http_;
};

}  // namespace slicefarm::coordinator
