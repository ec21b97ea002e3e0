#include "common/rpc/address/socket_address.h"

namespace slicefarm::rpc {

SocketAddresses ResolveSocketAddress(const std::string& address, int flags) {
  const size_t colon = address.rfind(':');
  std::string host = address.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  addrinfo hints = {};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = flags;
  addrinfo* found = nullptr;
  if (getaddrinfo(host.c_str(), address.substr(colon + 1).c_str(), &hints, &found) != 0)
    found = nullptr;
  return {found, freeaddrinfo};
}

}  // namespace slicefarm::rpc
