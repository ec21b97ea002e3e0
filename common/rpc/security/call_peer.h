#pragma once

#include <grpcpp/server_context.h>

#include <optional>
#include <string>

#include "absl/status/statusor.h"

namespace slicefarm::rpc {

/// Client of a call.
struct CallPeer {
  std::string identity = {};     ///< identity in the certificate (identity.h); empty: there is none
  bool certified = false;        ///< true if the client has presented a valid certificate
  std::string fingerprint = {};  ///< SHA-256 of the certificate, 64 hex digits; empty without one
  /// Address in gRPC's form, `ipv4:10.1.2.3:40000`. For a client of the proxy: only its IP address.
  std::string address = {};
};

/// Metadata keys by which the farm's proxy describes its own client: a URL-encoded PEM certificate
/// that the proxy has verified, and an IP address. deploy/proxy/nginx.conf.in sets them.
inline constexpr char kProxiedCertificate[] = "slicefarm-client-cert";
inline constexpr char kProxiedAddress[] = "slicefarm-client-address";

/// Returns the peer of a call. If the peer is the farm's proxy (kProxyIdentity), returns the client
/// that the proxy describes. Errors: PERMISSION_DENIED if any other peer sends these keys;
/// UNAUTHENTICATED if the certificate from the proxy cannot be read.
absl::StatusOr<CallPeer> PeerOf(const grpc::ServerContextBase& context);

/// Returns the identity and the fingerprint of a URL-encoded PEM certificate; nullopt if it is not
/// a certificate. The function does not check the signature and the dates.
std::optional<CallPeer> PeerOfCertificate(const std::string& escaped_pem);

}  // namespace slicefarm::rpc
