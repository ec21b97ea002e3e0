#pragma once

#include <grpcpp/server_context.h>

#include <optional>
#include <string>

#include "absl/status/statusor.h"

namespace slicefarm::rpc {

/// Who makes a call.
struct CallPeer {
  std::string identity = {};     ///< of the certificate (identity.h); empty: it has none
  bool certified = false;        ///< a certificate was shown and was valid
  std::string fingerprint = {};  ///< SHA-256 of the certificate, 64 hex digits; empty without one
  std::string address = {};  ///< as gRPC writes it, `ipv4:10.1.2.3:40000`; behind the proxy, the IP
};

/// The metadata by which the farm's proxy names its own peer: a URL-encoded PEM certificate that
/// the proxy has verified, and an IP address. deploy/proxy/nginx.conf.in sets them.
inline constexpr char kProxiedCertificate[] = "slicefarm-client-cert";
inline constexpr char kProxiedAddress[] = "slicefarm-client-address";

/// The peer of a call; if that is the farm's proxy (kProxyIdentity), the peer that the proxy names.
/// Errors: PERMISSION_DENIED if anybody but the proxy names another peer; UNAUTHENTICATED if the
/// proxy names a certificate that cannot be read.
absl::StatusOr<CallPeer> PeerOf(const grpc::ServerContextBase& context);

/// The identity and the fingerprint of a URL-encoded PEM certificate; nullopt if it is none. The
/// signature and the dates are not looked at.
std::optional<CallPeer> PeerOfCertificate(const std::string& escaped_pem);

}  // namespace slicefarm::rpc
