#pragma once

#include <string>

namespace slicefarm::rpc {

/// Returns the host of an address: "127.0.0.1" of "127.0.0.1:50050", "::1" of "[::1]:50050".
std::string HostOf(const std::string& address);

/// Returns false if the number after the last colon is not a valid port. gRPC would not report an
/// error: it would serve on this number modulo 65536.
bool PortFits(const std::string& address);

/// Returns true if only this machine can reach a server that listens on `address`: for `localhost`
/// and numeric loopback addresses. Returns false for any other name, because it may be resolved
/// differently later.
bool IsLoopback(const std::string& address);

}  // namespace slicefarm::rpc
