#pragma once

struct sockaddr;

namespace slicefarm::coordinator {

/// True for addresses that anybody on the Internet may have: not those of this machine, of private
/// networks, of links, for documentation, multicast or reserved (RFC 6890), nor IPv6 addresses that
/// stand for such IPv4 ones (RFC 4291, 6052, 3056). Other families than IPv4 and IPv6 are not.
bool IsPublicAddress(const sockaddr& address);

}  // namespace slicefarm::coordinator
