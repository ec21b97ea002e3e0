#pragma once

#include <grpcpp/security/credentials.h>
#include <grpcpp/security/server_credentials.h>

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "common/rpc/observe/json_log.h"
#include "common/rpc/security/tls_files.h"

namespace grpc::experimental {
class FileWatcherCertificateProvider;
}

namespace slicefarm::rpc {

/// Selects whether a server accepts clients without a certificate. A certificate that a client
/// presents must be valid in both cases.
enum class ClientCerts { kRequired, kOptional };

/// TLS credentials of a program, from its files. The files are checked every second; renewed files
/// apply to new connections without a restart. If renewed files cannot be read, the old files
/// remain in use. As long as a key does not match its certificate, no new connection succeeds.
/// Therefore replace key and certificate at the same time, by renaming their directory or the link
/// to it. Thread-safe.
class Tls {
 public:
  /// Reads the files. Errors: any error of CheckTlsFiles.
  static absl::StatusOr<std::shared_ptr<const Tls>> Open(const TlsFiles& files);

  /// Returns credentials of a server. REQUIRES: a certificate.
  std::shared_ptr<grpc::ServerCredentials> ForServer(ClientCerts client_certs) const;

  /// Returns credentials of a client that verifies the name of the server: the server's certificate
  /// must contain the host of the address.
  std::shared_ptr<grpc::ChannelCredentials> ForServerName() const;

  /// Returns credentials of a client that verifies the identity of the server: the server's
  /// certificate must have `identity` (identity.h), at any address. A refused server is logged.
  std::shared_ptr<grpc::ChannelCredentials> ForIdentity(const std::string& identity,
                                                        const JsonLog& log) const;

 private:
  using Provider = grpc::experimental::FileWatcherCertificateProvider;

  Tls(bool has_certificate, std::shared_ptr<Provider> provider)
      : has_certificate_(has_certificate), provider_(std::move(provider)) {}

  const bool has_certificate_;
  const std::shared_ptr<Provider> provider_;  // gRPC's own handle
};

}  // namespace slicefarm::rpc
