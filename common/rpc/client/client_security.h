#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "common/rpc/client/channel.h"
#include "common/rpc/security/tls_files.h"

namespace CLI {
class App;
}

namespace slicefarm::rpc {

/// Files and names with which a client program verifies its server and identifies itself.
struct ClientSecurity {
  TlsFiles tls = {};
  /// Name that the server's certificate must contain; empty: the host of the server's address.
  std::string server_name = {};
  /// true: calls send the token of token_file or of the environment, if there is one
  bool with_token = false;
  /// file with the token; empty: the token is read from the environment
  std::string token_file = {};
};

/// Adds --tls-ca, --tls-cert, --tls-key and --tls-server-name. An environment variable can also set
/// each of these options.
void AddTlsOptions(CLI::App& app, ClientSecurity* security);

/// Adds --token-file, for servers that require tokens.
void AddTokenOptions(CLI::App& app, ClientSecurity* security);

/// Returns `options` with the security settings, for a channel to `server`. Errors: any error of
/// CheckTlsFiles; REQUEST_MALFORMED if the token cannot be read, or would be sent unencrypted to
/// another machine.
absl::StatusOr<ChannelOptions> Secured(ChannelOptions options, const ClientSecurity& security,
                                       const std::string& server);

/// Returns the probable cause of a connection that failed or ended at its start, as an addition to
/// the error message. Detects only causes that concern certificates, and ports without a gRPC
/// server; otherwise returns an empty text. The cause is uncertain, because a server that refuses
/// the client's certificate only closes the connection (TLS 1.3).
std::string ConnectionHint(const absl::Status& status, const ClientSecurity& security);

}  // namespace slicefarm::rpc
