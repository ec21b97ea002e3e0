#pragma once

#include <string>

#include "common/rpc/security/tls_files.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace slicefarm::rpc {

/// --tls-ca, --tls-cert and --tls-key, which are those of clients and servers alike: one
/// environment (SLICEFARM_TLS_CA, ...) does for all programs of a farm. What each is good for, and
/// which others it needs, is the program's to say.
CLI::Option* AddTlsCa(CLI::App& app, TlsFiles* files, const std::string& about);
CLI::Option* AddTlsCert(CLI::App& app, TlsFiles* files, const std::string& about);
CLI::Option* AddTlsKey(CLI::App& app, TlsFiles* files, const std::string& about);

}  // namespace slicefarm::rpc
