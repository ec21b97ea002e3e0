#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::rpc {

/// Who may call what. The format is that of gRPC's own authorization policies (proposal A43), as
/// far as principals and paths go:
///
///   {"name": "stage",
///    "deny_rules":  [],
///    "allow_rules": [{"name": "coordinator",
///                     "source":  {"principals": ["spiffe://slicefarm/coordinator"]},
///                     "request": {"paths": ["/slicefarm.v1.*"]}}]}
///
/// A pattern is the whole text, `prefix*`, `*suffix`, or `*`: anything but the empty text, which is
/// the principal of a peer without a certificate. A rule fits a call if one of its principals and
/// one of its paths does; those that it does not name fit any. A call goes through if no deny rule
/// and one of the allow rules fits it.
///
/// Evaluated here because the library of gRPC that does it (grpc_authorization_provider) is not
/// among what its CMake build makes, and so not in Debian's packages: of 1.51 there is the header
/// only. Keys that are not known, such as `headers`, are refused.
class AuthzPolicy {
 public:
  /// Errors: REQUEST_MALFORMED, naming the place.
  static absl::StatusOr<AuthzPolicy> Parse(std::string_view json);

  /// `principal`: the caller's identity. `path`: "/slicefarm.v1.Beading/BeadLayers".
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
