#pragma once

#include <string>

namespace slicefarm::rpc {

/// "127.0.0.1" of "127.0.0.1:50050", "::1" of "[::1]:50050".
std::string HostOf(const std::string& address);

/// False if a number is after the last colon that is no port: gRPC would serve on what is left of
/// it modulo 65536.
bool PortFits(const std::string& address);

/// True if only this machine can reach a server there: `localhost` and numeric loopback addresses.
/// What other names stand for may change, so none of them counts.
bool IsLoopback(const std::string& address);

}  // namespace slicefarm::rpc
