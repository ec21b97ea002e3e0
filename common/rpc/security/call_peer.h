#pragma once

#include <grpcpp/server_context.h>

#include <optional>
#include <string>

#include "absl/status/statusor.h"

namespace slicefarm::rpc {

/// The client of a call.
struct CallPeer {
  std::string identity = {};     ///< identity in the certificate (identity.h); empty: there is none
  bool certified = false;        ///< the client showed a valid certificate
  std::string fingerprint = {};  ///< SHA-256 of the certificate, 64 hex digits; empty without one
  std::string address = {};  ///< in gRPC's form, `ipv4:10.1.2.3:40000`; behind the proxy, the IP
};

/// Metadata in which the farm's proxy names its own client: a URL-encoded PEM certificate that the
/// proxy has verified, and an IP address. deploy/proxy/nginx.conf.in sets them.
inline constexpr char kProxiedCertificate[] = "slicefarm-client-cert";
inline constexpr char kProxiedAddress[] = "slicefarm-client-address";

/// Returns the peer of a call. If this is the farm's proxy (kProxyIdentity), returns the client
/// that the proxy names. Errors: PERMISSION_DENIED if any other peer names a client;
/// UNAUTHENTICATED if the proxy names a certificate that cannot be read.
absl::StatusOr<CallPeer> PeerOf(const grpc::ServerContextBase& context);

/// Returns the identity and the fingerprint of a URL-encoded PEM certificate; nullopt if it is not
/// a certificate. The function does not check the signature and the dates.
std::optional<CallPeer> PeerOfCertificate(const std::string& escaped_pem);

}  // namespace slicefarm::rpc
