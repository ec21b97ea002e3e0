#pragma once

struct sockaddr;

namespace slicefarm::coordinator {

/// Returns true if the address is public, so that any Internet host may have it. Returns false for
/// addresses of this machine, of private networks and of single links, and for documentation,
/// multicast and reserved addresses (RFC 6890). Also returns false for IPv6 addresses that
/// represent one of these IPv4 addresses (RFC 4291, 6052, 3056), and for families other than IPv4
/// and IPv6.
bool IsPublicAddress(const sockaddr& address);

}  // namespace slicefarm::coordinator
