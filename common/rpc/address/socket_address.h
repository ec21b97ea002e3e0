#pragma once

#include <netdb.h>

#include <memory>
#include <string>

namespace slicefarm::rpc {

using SocketAddresses = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

/// Returns the stream socket addresses to which `address` (host:port; an IPv6 host in brackets)
/// resolves, the preferred address first. Returns null if there are none. `flags`: flags of
/// getaddrinfo; AI_PASSIVE for a server that listens on the address.
SocketAddresses ResolveSocketAddress(const std::string& address, int flags = 0);

}  // namespace slicefarm::rpc
