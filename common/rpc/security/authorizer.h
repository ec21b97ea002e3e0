#pragma once

#include <grpcpp/security/auth_metadata_processor.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "common/model/process.h"
#include "common/rpc/security/authz_policy.h"
#include "common/rpc/security/file_watch.h"
#include "common/rpc/observe/json_log.h"

namespace slicefarm::rpc {

/// Of a service between services: its methods are the coordinator's; anybody with a certificate may
/// ask for health and reflection.
std::string_view InnerPolicy();

/// Of a service that judges its callers itself, call by call.
std::string_view OpenPolicy();

/// Lets a policy decide on each call of a server with TLS, before any handler sees it: to be given
/// to its credentials. What is refused ends as UNAUTHENTICATED (a peer without an identity) or
/// PERMISSION_DENIED. Thread-safe.
class Authorizer : public grpc::AuthMetadataProcessor {
 public:
  /// `builtin`: a policy. Errors: those of AuthzPolicy::Parse.
  static absl::StatusOr<std::shared_ptr<Authorizer>> Make(std::string_view builtin, JsonLog log);

  /// The policy of a file instead, and again whenever it changes. One that cannot be read or used
  /// leaves the last one in force, with an error in the log. Errors: those of ReadTextFile and
  /// AuthzPolicy::Parse.
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
  std::optional<FileWatch> watch_;  ///< the last member: its thread uses the others
};

}  // namespace slicefarm::rpc
