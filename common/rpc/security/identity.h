#pragma once

#include <grpcpp/security/auth_context.h>

#include <optional>
#include <string>
#include <string_view>

namespace slicefarm::rpc {

/// Whom a certificate speaks for: the URI among its subject's alternative names, in the form of a
/// SPIFFE ID. Addresses and host names say where a program runs, and not what it may do.

inline constexpr char kCoordinatorIdentity[] = "spiffe://slicefarm/coordinator";
/// Of the proxy that stands before the coordinators (deploy/proxy), and speaks for its clients.
inline constexpr char kProxyIdentity[] = "spiffe://slicefarm/proxy";
inline constexpr char kWorkerIdentity[] = "spiffe://slicefarm/worker";

/// `stage`: "beading" of slicefarm-beading.
std::string StageIdentity(std::string_view stage);

/// The tenant of `spiffe://slicefarm/tenant/NAME`; nullopt for any other identity.
std::optional<std::string> TenantOfIdentity(std::string_view identity);

/// The identity of a call's peer; empty if it showed no certificate, or one that has not exactly
/// one URI.
std::string PeerIdentity(const grpc::AuthContext& context);

}  // namespace slicefarm::rpc
