#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::rpc {

/// Access policy: rules that consist of principals (identities of callers) and of the methods that
/// they may call. The format is a subset of gRPC's authorization policies (proposal A43), with
/// principals and paths only:
///
///   {"name": "stage",
///    "deny_rules":  [],
///    "allow_rules": [{"name": "coordinator",
///                     "source":  {"principals": ["spiffe://slicefarm/coordinator"]},
///                     "request": {"paths": ["/slicefarm.v1.*"]}}]}
///
/// A pattern is a whole text, `prefix*`, `*suffix`, or `*`. `*` matches every text except the empty
/// one, which is the principal of a peer without a certificate. A rule matches a call if one of its
/// principals and one of its paths match. A missing list matches every call. A call is allowed if
/// no deny rule and at least one allow rule matches it.
///
/// Policies are evaluated by this class, because Debian's packages do not contain gRPC's library
/// for it (grpc_authorization_provider). gRPC's CMake build does not make this library; version
/// 1.51 has only the header. Unknown keys, such as `headers`, are refused.
class AuthzPolicy {
 public:
  /// Reads a policy from JSON. Errors: REQUEST_MALFORMED, which names the position in the policy.
  static absl::StatusOr<AuthzPolicy> Parse(std::string_view json);

  /// Returns true if the call is allowed. `principal`: the caller's identity. `path`:
  /// "/slicefarm.v1.Beading/BeadLayers".
  bool Allows(std::string_view principal, std::string_view path) const;

 private:
  struct Rule {
    std::vector<std::string> principals;
    std::vector<std::string> paths;
  };
  friend class PolicyReader;

  std::vector<Rule> deny_;
  std::vector<Rule> allow_;
};

}  // namespace slicefarm::rpc
