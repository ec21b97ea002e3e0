#pragma once

#include <grpcpp/security/auth_context.h>

#include <optional>
#include <string>
#include <string_view>

namespace slicefarm::rpc {

// An identity is the URI among the subject alternative names of a certificate, in the form of a
// SPIFFE ID. Addresses and host names in the certificate are ignored: they describe where a
// program runs, not its permissions.

inline constexpr char kCoordinatorIdentity[] = "spiffe://slicefarm/coordinator";
/// Identity of the proxy in front of the coordinators (deploy/proxy), which passes on calls of its
/// clients.
inline constexpr char kProxyIdentity[] = "spiffe://slicefarm/proxy";
inline constexpr char kWorkerIdentity[] = "spiffe://slicefarm/worker";

/// Returns the identity of a stage's service. `stage`: for example "beading", for
/// slicefarm-beading.
std::string StageIdentity(std::string_view stage);

/// Returns the tenant of `spiffe://slicefarm/tenant/NAME`; nullopt for any other identity.
std::optional<std::string> TenantOfIdentity(std::string_view identity);

/// Returns the identity of a call's peer; empty if the peer has presented no certificate, or a
/// certificate without exactly one URI.
std::string PeerIdentity(const grpc::AuthContext& context);

}  // namespace slicefarm::rpc
