#pragma once

#include <netdb.h>

#include <memory>
#include <string>

namespace slicefarm::rpc {

using SocketAddresses = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

/// The addresses of a stream socket that `address` (host:port; an IPv6 host in brackets) stands
/// for, the first one first; null: there are none. `flags`: AI_PASSIVE to listen there.
SocketAddresses ResolveSocketAddress(const std::string& address, int flags = 0);

}  // namespace slicefarm::rpc
