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
    if (!absl::ascii_isgraph(c))
      return Refused("the token contains characters that a token cannot have");
  }
  if (token.empty() && !security.token_file.empty()) {
    return Refused(security.token_file + " contains no token");
  }
  return token;
}

}  // namespace

void AddTlsOptions(CLI::App& app, ClientSecurity* security) {
  auto* ca = AddTlsCa(
      app, &security->tls,
      "CA certificates that sign the server's certificate; with it, the connection uses TLS");
  auto* cert = AddTlsCert(app, &security->tls, "Certificate of this client");
  auto* key = AddTlsKey(app, &security->tls, "Private key of the certificate");
  cert->needs(key)->needs(ca);
  key->needs(cert);
  app.add_option("--tls-server-name", security->server_name,
                 "Name in the server's certificate, if it differs from the host name")
      ->envname("SLICEFARM_TLS_SERVER_NAME")
      ->type_name("NAME")
      ->needs(ca);
}

void AddTokenOptions(CLI::App& app, ClientSecurity* security) {
  security->with_token = true;
  app.add_option(
         "--token-file", security->token_file,
         std::string(
             "File with the token that the server requires. Without this option, the variable ") +
             kTokenVariable + " may contain the token")
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
    return ": nothing listens at this address";
  const bool is_grpc = !absl::StrContains(message, "Failed parsing HTTP/2") &&
                       !absl::StrContains(message, "http1.x server");
  if (absl::IsUnavailable(status) && !is_grpc)
    return "; a program that is not a gRPC server listens there: is the port that of the metrics?";
  if (!absl::IsUnavailable(status) ||
      !(absl::StrContains(message, "Socket closed") ||
        absl::StrContains(message, "Connection reset") || absl::StrContains(message, "andshake"))) {
    return "";
  }
  if (!security.tls.enabled()) return "; the server may require TLS (--tls-ca)";
  if (security.tls.has_certificate()) {
    return absl::StrCat("; the server may not use TLS, or may refuse the certificate ",
                        security.tls.cert);
  }
  return "; the server may not use TLS, or may require a client certificate (--tls-cert, "
         "--tls-key)";
}

}  // namespace slicefarm::rpc
