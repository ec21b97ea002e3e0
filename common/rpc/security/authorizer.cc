#include "common/rpc/security/authorizer.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/rpc/security/identity.h"

namespace slicefarm::rpc {
namespace {

constexpr char kInnerPolicy[] = R"({
  "name": "inner",
  "allow_rules": [
    {"name": "coordinator",
     "source": {"principals": ["spiffe://slicefarm/coordinator"]},
     "request": {"paths": ["/slicefarm.v1.*"]}},
    {"name": "anybody known",
     "source": {"principals": ["*"]},
     "request": {"paths": ["/grpc.health.v1.Health/*", "/grpc.reflection.*"]}}
  ]
})";

constexpr char kOpenPolicy[] = R"({"name": "open", "allow_rules": [{"name": "anybody"}]})";

std::string PathOf(const grpc::AuthMetadataProcessor::InputMetadata& metadata) {
  const auto path = metadata.find(":path");
  if (path == metadata.end()) return "";
  return {path->second.data(), path->second.size()};
}

}  // namespace

std::string_view InnerPolicy() { return kInnerPolicy; }

std::string_view OpenPolicy() { return kOpenPolicy; }

absl::StatusOr<std::shared_ptr<Authorizer>> Authorizer::Make(std::string_view builtin,
                                                             JsonLog log) {
  auto policy = AuthzPolicy::Parse(builtin);
  if (!policy.ok()) return policy.status();
  return std::shared_ptr<Authorizer>(new Authorizer(*std::move(policy), std::move(log)));
}

absl::StatusOr<std::shared_ptr<Authorizer>> Authorizer::Watch(const std::string& path, JsonLog log,
                                                              std::chrono::milliseconds every) {
  auto text = ReadTextFile(path);
  if (!text.ok()) return text.status();
  auto authorizer = Make(*text, std::move(log));
  if (!authorizer.ok()) return authorizer;
  (*authorizer)
      ->watch_.emplace(
          path, *std::move(text),
          [&self = **authorizer](const auto& changed) { self.Reload(changed); }, every);
  return authorizer;
}

void Authorizer::Reload(const absl::StatusOr<std::string>& text) {
  auto policy = text.ok() ? AuthzPolicy::Parse(*text) : text.status();
  if (!policy.ok()) {
    return log_.Error("the last authorization policy remains in use",
                      {{"error", std::string(policy.status().message())}});
  }
  {
    const std::lock_guard lock(mutex_);
    policy_ = *std::move(policy);
  }
  log_.Info("new authorization policy");
}

grpc::Status Authorizer::Process(const InputMetadata& metadata, grpc::AuthContext* context,
                                 OutputMetadata* /*consumed*/, OutputMetadata* /*response*/) {
  const std::string principal = PeerIdentity(*context);
  const std::string path = PathOf(metadata);
  {
    const std::lock_guard lock(mutex_);
    if (policy_.Allows(principal, path)) return grpc::Status::OK;
  }
  log_.Warn("call refused", {{"method", path}, {"peer", principal}});
  if (principal.empty()) {
    return {grpc::StatusCode::UNAUTHENTICATED,
            absl::StrCat(path, " needs a certificate that names an identity")};
  }
  return {grpc::StatusCode::PERMISSION_DENIED, absl::StrCat(principal, " may not call ", path)};
}

}  // namespace slicefarm::rpc
