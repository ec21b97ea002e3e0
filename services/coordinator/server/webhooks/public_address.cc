#include "services/coordinator/server/webhooks/public_address.h"

#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace slicefarm::coordinator {
namespace {

struct Block {
  uint32_t first;
  int bits;
};

constexpr uint32_t Ip(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  return a << 24 | b << 16 | c << 8 | d;
}

/// Blocks of RFC 6890, multicast (RFC 5771) and class E.
constexpr std::array kSpecial = {
    Block{Ip(0, 0, 0, 0), 8},      Block{Ip(10, 0, 0, 0), 8},     Block{Ip(100, 64, 0, 0), 10},
    Block{Ip(127, 0, 0, 0), 8},    Block{Ip(169, 254, 0, 0), 16}, Block{Ip(172, 16, 0, 0), 12},
    Block{Ip(192, 0, 0, 0), 24},   Block{Ip(192, 0, 2, 0), 24},   Block{Ip(192, 88, 99, 0), 24},
    Block{Ip(192, 168, 0, 0), 16}, Block{Ip(198, 18, 0, 0), 15},  Block{Ip(198, 51, 100, 0), 24},
    Block{Ip(203, 0, 113, 0), 24}, Block{Ip(224, 0, 0, 0), 4},    Block{Ip(240, 0, 0, 0), 4}};

bool IsPublic(uint32_t ip) {
  return std::ranges::none_of(
      kSpecial, [ip](const Block& block) { return (ip ^ block.first) >> (32 - block.bits) == 0; });
}

uint32_t Ipv4At(const uint8_t* bytes) { return Ip(bytes[0], bytes[1], bytes[2], bytes[3]); }

bool StartsWith(const uint8_t* bytes, std::initializer_list<uint8_t> prefix) {
  return std::equal(prefix.begin(), prefix.end(), bytes);
}

bool IsPublic(const in6_addr& address) {
  const uint8_t* bytes = address.s6_addr;
  if (StartsWith(bytes, {0, 0x64, 0xff, 0x9b, 0, 0, 0, 0, 0, 0, 0, 0}))
    return IsPublic(Ipv4At(bytes + 12));
  if (StartsWith(bytes, {0x20, 0x02})) return IsPublic(Ipv4At(bytes + 2));  // 6to4
  if (IN6_IS_ADDR_V4MAPPED(&address)) return IsPublic(Ipv4At(bytes + 12));
  if (StartsWith(bytes, {0x20, 0x01, 0x0d, 0xb8})) return false;                // documentation
  if (StartsWith(bytes, {0x20, 0x01}) && (bytes[2] & 0xfe) == 0) return false;  // IETF protocols
  return (bytes[0] & 0xe0) == 0x20;  // global unicast, 2000::/3
}

}  // namespace

bool IsPublicAddress(const sockaddr& address) {
  if (address.sa_family == AF_INET) {
    sockaddr_in ipv4 = {};
    std::memcpy(&ipv4, &address, sizeof(ipv4));
    return IsPublic(ntohl(ipv4.sin_addr.s_addr));
  }
  if (address.sa_family == AF_INET6) {
    sockaddr_in6 ipv6 = {};
    std::memcpy(&ipv6, &address, sizeof(ipv6));
    return IsPublic(ipv6.sin6_addr);
  }
  return false;
}

}  // namespace slicefarm::coordinator
