#include "common/rpc/security/tls_options.h"

#include <CLI/CLI.hpp>

namespace slicefarm::rpc {
namespace {

CLI::Option* AddFile(CLI::App& app, const std::string& option, const std::string& variable,
                     std::string* path, const std::string& about) {
  return app.add_option(option, *path, about)->envname(variable)->type_name("FILE");
}

}  // namespace

CLI::Option* AddTlsCa(CLI::App& app, TlsFiles* files, const std::string& about) {
  return AddFile(app, "--tls-ca", "SLICEFARM_TLS_CA", &files->ca, about);
}

CLI::Option* AddTlsCert(CLI::App& app, TlsFiles* files, const std::string& about) {
  return AddFile(app, "--tls-cert", "SLICEFARM_TLS_CERT", &files->cert, about);
}

CLI::Option* AddTlsKey(CLI::App& app, TlsFiles* files, const std::string& about) {
  return AddFile(app, "--tls-key", "SLICEFARM_TLS_KEY", &files->key, about);
}

}  // namespace slicefarm::rpc
