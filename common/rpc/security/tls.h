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

/// Whether a server takes clients that show no certificate. One that is shown must be valid.
enum class ClientCerts { kRequired, kOptional };

/// TLS of a program, from its files. It looks at them every second: renewed ones hold for new
/// connections, without a restart. Those that cannot be read leave the old ones in force; a key
/// that does not belong to its certificate lets no new connection come about until it does, so both
/// are to be replaced at once (by renaming the directory, or the link to it). Thread-safe.
class Tls {
 public:
  /// Errors: those of CheckTlsFiles.
  static absl::StatusOr<std::shared_ptr<const Tls>> Open(const TlsFiles& files);

  /// REQUIRES: a certificate.
  std::shared_ptr<grpc::ServerCredentials> ForServer(ClientCerts client_certs) const;

  /// For clients that know a server by its name: the host's of the address must be one of the
  /// certificate's.
  std::shared_ptr<grpc::ChannelCredentials> ForServerName() const;

  /// For clients that know a server by what it is, whatever its address: its certificate must be
  /// `identity`'s (identity.h). One that is not goes to the log.
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
