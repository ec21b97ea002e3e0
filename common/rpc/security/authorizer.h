#pragma once

#include <grpcpp/security/auth_metadata_processor.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "common/model/process.h"
#include "common/rpc/observe/json_log.h"
#include "common/rpc/security/authz_policy.h"
#include "common/rpc/security/file_watch.h"

namespace slicefarm::rpc {

/// Returns the default policy of an internal service, such as a stage. The coordinator may call all
/// methods of the service. Any client with a certificate may call health and reflection.
std::string_view InnerPolicy();

/// Returns the policy of a service that checks the caller of each call itself: it allows all calls.
std::string_view OpenPolicy();

/// Applies a policy to each call of a server with TLS, before any handler runs. The server's
/// credentials contain this object. A refused call ends as UNAUTHENTICATED if the peer has no
/// identity, otherwise as PERMISSION_DENIED. Thread-safe.
class Authorizer : public grpc::AuthMetadataProcessor {
 public:
  /// Makes an authorizer with the policy text `builtin`. Errors: any error of AuthzPolicy::Parse.
  static absl::StatusOr<std::shared_ptr<Authorizer>> Make(std::string_view builtin, JsonLog log);

  /// Makes an authorizer with the policy in a file, and reads the file again whenever it changes.
  /// If the new policy cannot be read or used, the old policy remains in force and an error is
  /// logged. Errors, for the first policy: any error of ReadTextFile and AuthzPolicy::Parse.
  static absl::StatusOr<std::shared_ptr<Authorizer>> Watch(
      const std::string& path, JsonLog log,
      std::chrono::milliseconds every = std::chrono::seconds(1));

  bool IsBlocking() const override { return false; }
  grpc::Status Process(const InputMetadata& metadata, grpc::AuthContext* context,
                       OutputMetadata* consumed, OutputMetadata* response) override;

 private:
  Authorizer(AuthzPolicy policy, JsonLog log) : log_(std::move(log)), policy_(std::move(policy)) {}
  void Reload(const absl::StatusOr<std::string>& text);

  const JsonLog log_;
  std::mutex mutex_;
  AuthzPolicy policy_;
  std::optional<FileWatch> watch_;  ///< the last member, because its thread uses all other members
};

}  // namespace slicefarm::rpc
