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

/// Keys of a bucket.
struct S3Credentials {
  std::string access_key;
  std::string secret_key;
  std::string session_token = {};  ///< of keys that are for some time; empty: none
};

/// The credentials as they are now.
using S3CredentialsNow = std::function<std::shared_ptr<const S3Credentials>()>;

struct S3Options {
  S3Address address;
  std::string region = "us-east-1";
  S3CredentialsNow credentials;
  HttpClientOptions http = {};
  int tries = 4;                               ///< of what may go better a moment later
  std::chrono::milliseconds first_pause{200};  ///< twice as long each time
};

/// Objects of a bucket, by Amazon's S3 API or another one that speaks it. Thread-safe.
///
/// Errors of all: NotFound for an object that is not there; PermissionDenied if the bucket refuses
/// us; CANCELLED by the thread's CancelScope, also between two tries; Unavailable for everything
/// else, after as many tries as the options say.
class S3Client {
 public:
  explicit S3Client(S3Options options) : options_(std::move(options)), http_(options_.http) {}

  /// The server compares the digest with what came, so that nothing else becomes the object.
  /// Errors also: those of the body.
  absl::Status Put(const std::string& key, const std::string& sha256, const BodySource& body);

  /// `count` bytes from `offset` on; fewer if the object ends before. REQUIRES: count >= 1.
  absl::StatusOr<std::string> Get(const std::string& key, int64_t offset, int64_t count);

  absl::StatusOr<int64_t> Size(const std::string& key);

  /// Nothing happens to one that is not there.
  absl::Status Delete(const std::string& key);

  /// Writes a small object and reads it, so that a wrong address or secret shows.
  absl::Status Probe();

 private:
  struct Wanted;

  absl::StatusOr<HttpAnswer> Ask(const Wanted& wanted);
  absl::StatusOr<HttpAnswer> AskOnce(const Wanted& wanted, const CancelToken& cancel, bool& again);

  const S3Options options_;
  HttpClient http_;
};

}  // namespace slicefarm::coordinator
