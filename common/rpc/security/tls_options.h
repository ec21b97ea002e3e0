#pragma once

#include <string>

#include "common/rpc/security/tls_files.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace slicefarm::rpc {

/// Adds --tls-ca. Clients and servers have the same options --tls-ca, --tls-cert and --tls-key,
/// with the same environment variables (SLICEFARM_TLS_CA, ...), so one environment serves all
/// programs of a farm. `about`: description of the option in this program; the caller also adds the
/// dependencies on other options.
CLI::Option* AddTlsCa(CLI::App& app, TlsFiles* files, const std::string& about);
/// Adds --tls-cert. `about`: description of the option.
CLI::Option* AddTlsCert(CLI::App& app, TlsFiles* files, const std::string& about);
/// Adds --tls-key. `about`: description of the option.
CLI::Option* AddTlsKey(CLI::App& app, TlsFiles* files, const std::string& about);

}  // namespace slicefarm::rpc
