#include "common/rpc/address/listen_address.h"

#include <gtest/gtest.h>

namespace slicefarm::rpc::listen_address_test {
namespace {

TEST(ListenAddress, LoopbackIsWhatOnlyThisMachineReaches) {
  for (const char* address : {"127.0.0.1:1", "127.9.8.7:1", "localhost:1", "[::1]:1"}) {
    EXPECT_TRUE(IsLoopback(address)) << address;
  }
  for (const char* address : {"0.0.0.0:1", "[::]:1", "10.0.0.1:1", "farm:1", "localhost.farm:1",
                              "127.0.0.1.farm:1", "[fe80::1]:1", ":1", ""}) {
    EXPECT_FALSE(IsLoopback(address)) << address;
  }
}

TEST(ListenAddress, ANumberBeyondAllPortsIsNone) {
  for (const char* address : {"127.0.0.1:0", "127.0.0.1:65535", "[::1]:50051", "farm:https"}) {
    EXPECT_TRUE(PortFits(address)) << address;
  }
  for (const char* address : {"127.0.0.1:65536", "[::]:500510", "farm:99999999999999999999"}) {
    EXPECT_FALSE(PortFits(address)) << address;
  }
}

}  // namespace
}  // namespace slicefarm::rpc::listen_address_test
