#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "common/rpc/client/channel.h"
#include "common/rpc/security/tls_files.h"

namespace CLI {
class App;
}

namespace slicefarm::rpc {

/// Settings by which a client program verifies its server and identifies itself.
struct ClientSecurity {
  TlsFiles tls = {};
  /// Name in the server's certificate; empty: the host of the server's address.
  std::string server_name = {};
  bool with_token = false;      ///< true if each call sends a token, provided that one is given
  std::string token_file = {};  ///< empty: the token is read from the environment
};

/// Adds --tls-ca, --tls-cert, --tls-key and --tls-server-name. Each can also be set by an
/// environment variable.
void AddTlsOptions(CLI::App& app, ClientSecurity* security);

/// Adds --token-file, for servers that require tokens.
void AddTokenOptions(CLI::App& app, ClientSecurity* security);

/// Returns `options` with the security settings, for a channel to `server`. Errors: see
/// CheckTlsFiles; REQUEST_MALFORMED if the token cannot be read, or would be sent unencrypted to
/// another machine.
absl::StatusOr<ChannelOptions> Secured(ChannelOptions options, const ClientSecurity& security,
                                       const std::string& server);

/// Returns the possible cause of a connection that failed, or that ended at its start, as an
/// addition to the error message. Only detects causes that concern certificates, and ports without
/// a gRPC server; otherwise returns an empty text. The cause is uncertain, because a server that
/// refuses the client's certificate only closes the connection (TLS 1.3).
std::string ConnectionHint(const absl::Status& status, const ClientSecurity& security);

}  // namespace slicefarm::rpc
