#pragma once

#include <string>

#include "common/rpc/security/tls_files.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace slicefarm::rpc {

/// Options --tls-ca, --tls-cert and --tls-key, which clients and servers share. One
/// environment (SLICEFARM_TLS_CA, ...) therefore suffices for all programs of a farm. Each program
/// describes the use of an option and its dependencies on other options.
CLI::Option* AddTlsCa(CLI::App& app, TlsFiles* files, const std::string& about);
/// Adds --tls-cert. `about`: description of the option.
CLI::Option* AddTlsCert(CLI::App& app, TlsFiles* files, const std::string& about);
/// Adds --tls-key. `about`: description of the option.
CLI::Option* AddTlsKey(CLI::App& app, TlsFiles* files, const std::string& about);

}  // namespace slicefarm::rpc
