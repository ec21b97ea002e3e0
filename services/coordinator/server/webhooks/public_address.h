#pragma once

struct sockaddr;

namespace slicefarm::coordinator {

/// Returns true if any Internet host may have the address. Returns false for addresses of this
/// machine, private networks and links, and for documentation, multicast and reserved addresses
/// (RFC 6890). Also returns false for IPv6 addresses that represent such IPv4 addresses (RFC 4291,
/// 6052, 3056), and for families other than IPv4 and IPv6.
bool IsPublicAddress(const sockaddr& address);

}  // namespace slicefarm::coordinator
