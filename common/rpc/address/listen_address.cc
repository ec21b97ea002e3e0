#include "common/rpc/address/listen_address.h"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <algorithm>
#include <cstdint>

#include "absl/strings/ascii.h"
#include "absl/strings/numbers.h"

namespace slicefarm::rpc {

std::string HostOf(const std::string& address) {
  std::string host = address.substr(0, address.rfind(':'));
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  return host;
}

bool PortFits(const std::string& address) {
  const std::string port = address.substr(address.rfind(':') + 1);
  // gRPC has names for some ports
  if (!std::ranges::all_of(port, absl::ascii_isdigit)) return true;
  uint32_t number = 0;
  return port.empty() || (absl::SimpleAtoi(port, &number) && number <= UINT16_MAX);
}

bool IsLoopback(const std::string& address) {
  const std::string host = HostOf(address);
  if (host == "localhost") return true;
  in_addr v4 = {};
  if (inet_pton(AF_INET, host.c_str(), &v4) == 1) return ntohl(v4.s_addr) >> 24 == 127;
  in6_addr v6 = {};
  return inet_pton(AF_INET6, host.c_str(), &v6) == 1 && IN6_IS_ADDR_LOOPBACK(&v6);
}

}  // namespace slicefarm::rpc
