#include "common/rpc/security/identity.h"

#include <grpc/grpc_security_constants.h>

#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/strip.h"

namespace slicefarm::rpc {

std::string StageIdentity(std::string_view stage) {
  return absl::StrCat("spiffe://slicefarm/stage/", std::string(stage));
}

std::optional<std::string> TenantOfIdentity(std::string_view identity) {
  absl::string_view name(identity.data(), identity.size());
  if (!absl::ConsumePrefix(&name, "spiffe://slicefarm/tenant/") || name.empty()) {
    return std::nullopt;
  }
  return std::string(name);
}

std::string PeerIdentity(const grpc::AuthContext& context) {
  const std::vector<grpc::string_ref> uris =
      context.FindPropertyValues(GRPC_PEER_URI_PROPERTY_NAME);
  if (uris.size() != 1) return "";
  return {uris[0].data(), uris[0].size()};
}

}  // namespace slicefarm::rpc
