#pragma once

#include <string>

namespace slicefarm::rpc {

/// Returns the host of an address: "127.0.0.1" of "127.0.0.1:50050", "::1" of "[::1]:50050".
std::string HostOf(const std::string& address);

/// Returns false if the port, the number after the last colon, is above 65535. gRPC would not
/// report an error: it would use the number modulo 65536 as the port. Returns true for a port given
/// by name.
bool PortFits(const std::string& address);

/// Returns true if only this machine can reach a server that listens on `address`: its host is
/// `localhost` or a numeric loopback address. Returns false for any other name, because the name
/// may be resolved differently later.
bool IsLoopback(const std::string& address);

}  // namespace slicefarm::rpc
