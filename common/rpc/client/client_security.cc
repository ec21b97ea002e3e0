#include "common/rpc/client/client_security.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/rpc/address/listen_address.h"
#include "common/rpc/security/file_watch.h"
#include "common/rpc/security/tls.h"
#include "common/rpc/security/tls_options.h"

namespace slicefarm::rpc {
namespace {

constexpr char kTokenVariable[] = "SLICEFARM_TOKEN";

absl::Status Refused(const std::string& what) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed, what);
}

absl::StatusOr<std::string> ReadToken(const ClientSecurity& security) {
  std::string token;
  if (!security.with_token) return token;
  if (security.token_file.empty()) {
    const char* variable = std::getenv(kTokenVariable);
    if (variable == nullptr) return token;
    token = variable;
  } else {
    auto text = ReadTextFile(security.token_file);
    if (!text.ok()) return text.status();
    token = *std::move(text);
  }
  absl::StripAsciiWhitespace(&token);
  for (const unsigned char c : token) {
    if (!absl::ascii_isgraph(c)) return Refused("the token has characters that no token has");
  }
  if (token.empty() && !security.token_file.empty()) {
    return Refused(security.token_file + " holds no token");
  }
  return token;
}

}  // namespace

void AddTlsOptions(CLI::App& app, ClientSecurity* security) {
  auto* ca = AddTlsCa(app, &security->tls,
                      "Speak TLS, with a server whose certificate one of these CAs signed");
  auto* cert = AddTlsCert(app, &security->tls, "This client's certificate");
  auto* key = AddTlsKey(app, &security->tls, "Its key");
  cert->needs(key)->needs(ca);
  key->needs(cert);
  app.add_option("--tls-server-name", security->server_name,
                 "The name in the server's certificate, if it is not the host's")
      ->envname("SLICEFARM_TLS_SERVER_NAME")
      ->type_name("NAME")
      ->needs(ca);
}

void AddTokenOptions(CLI::App& app, ClientSecurity* security) {
  security->with_token = true;
  app.add_option("--token-file", security->token_file,
                 std::string("Holds the token that the server asks for; or the variable ") +
                     kTokenVariable + " does")
      ->envname("SLICEFARM_TOKEN_FILE")
      ->type_name("FILE");
}

absl::StatusOr<ChannelOptions> Secured(ChannelOptions options, const ClientSecurity& security,
                                       const std::string& server) {
  auto token = ReadToken(security);
  if (!token.ok()) return token.status();
  options.token = *std::move(token);
  if (!security.tls.enabled()) {
    if (options.token.empty() || IsLoopback(server)) return options;
    return Refused("the token would go to " + server + " in plain text: give --tls-ca");
  }
  const auto tls = Tls::Open(security.tls);
  if (!tls.ok()) return tls.status();
  options.credentials = (*tls)->ForServerName();
  options.server_name = security.server_name;
  return options;
}

std::string ConnectionHint(const absl::Status& status, const ClientSecurity& security) {
  const absl::string_view message = status.message();
  if (absl::IsUnavailable(status) && absl::StrContains(message, "Connection refused"))
    return ": nothing listens there";
  const bool is_grpc = !absl::StrContains(message, "Failed parsing HTTP/2") &&
                       !absl::StrContains(message, "http1.x server");
  if (absl::IsUnavailable(status) && !is_grpc)
    return "; what listens there is no gRPC server: is it the port of the metrics?";
  if (!absl::IsUnavailable(status) ||
      !(absl::StrContains(message, "Socket closed") ||
        absl::StrContains(message, "Connection reset") || absl::StrContains(message, "andshake"))) {
    return "";
  }
  if (!security.tls.enabled()) return "; it may want TLS (--tls-ca)";
  if (security.tls.has_certificate()) {
    return absl::StrCat("; it may not speak TLS, or refuse the certificate ", security.tls.cert);
  }
  return "; it may not speak TLS, or want a client certificate (--tls-cert, --tls-key)";
}

}  // namespace slicefarm::rpc
