#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "common/rpc/client/channel.h"
#include "common/rpc/security/tls_files.h"

namespace CLI {
class App;
}

namespace slicefarm::rpc {

/// How a client program knows its server and tells who it is.
struct ClientSecurity {
  TlsFiles tls = {};
  std::string server_name = {};  ///< in the server's certificate; empty: the host of its address
  bool with_token = false;       ///< a token goes along with each call, if there is one
  std::string token_file = {};   ///< empty: it is that of the environment
};

/// --tls-ca, --tls-cert, --tls-key, --tls-server-name; each is also read from the environment.
void AddTlsOptions(CLI::App& app, ClientSecurity* security);

/// --token-file, for servers that ask for tokens.
void AddTokenOptions(CLI::App& app, ClientSecurity* security);

/// `options` for a channel to `server`. Errors: those of CheckTlsFiles; REQUEST_MALFORMED if the
/// token cannot be read, or would go in plain text to another machine.
absl::StatusOr<ChannelOptions> Secured(ChannelOptions options, const ClientSecurity& security,
                                       const std::string& server);

/// What is behind a connection that does not come about, or may be behind one that ends when it
/// begins; empty if that is neither a port where nothing listens nor to do with certificates. A server that refuses a client's certificate says no more
/// than that (TLS 1.3).
std::string ConnectionHint(const absl::Status& status, const ClientSecurity& security);

}  // namespace slicefarm::rpc
