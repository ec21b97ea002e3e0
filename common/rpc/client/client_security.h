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
  bool with_token = false;      ///< a token is sent with each call, if there is one
  std::string token_file = {};  ///< empty: the token is read from the environment
};

/// Adds --tls-ca, --tls-cert, --tls-key and --tls-server-name. Each can also be set in the
/// environment.
void AddTlsOptions(CLI::App& app, ClientSecurity* security);

/// Adds --token-file, for servers that require tokens.
void AddTokenOptions(CLI::App& app, ClientSecurity* security);

/// Returns `options` for a channel to `server`. Errors: errors of CheckTlsFiles; REQUEST_MALFORMED
/// if the token cannot be read, or would be sent unencrypted to another machine.
absl::StatusOr<ChannelOptions> Secured(ChannelOptions options, const ClientSecurity& security,
                                       const std::string& server);

/// Returns the possible cause of a connection that failed, or that ended at its start. Returns an
/// empty text unless the cause concerns certificates or a port without a server. A server that
/// refuses the client's certificate gives no other information (TLS 1.3).
std::string ConnectionHint(const absl::Status& status, const ClientSecurity& security);

}  // namespace slicefarm::rpc
