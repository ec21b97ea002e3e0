#include "services/coordinator/server/execution/disk_guard.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::coordinator::disk_guard_test {
namespace {

TEST(DiskGuard, KeepsAReserve) {
  const DiskGuard guard([] { return 1'000; }, 300);
  EXPECT_TRUE(guard.CheckSpace(700).ok());
  const ErrorDetail low = DetailOf(guard.CheckSpace(701));
  EXPECT_EQ(low.reason, Reason::kDiskLow);
  EXPECT_EQ(low.metadata.at("free_bytes"), "1000");
  EXPECT_TRUE(low.metadata.contains(rpc::kRetryAfterMs));
}

TEST(DiskGuard, WhatCannotBeAskedIsLeftToTheWrites) {
  EXPECT_TRUE(DiskGuard([] { return std::nullopt; }, 1).CheckSpace(1).ok());
  EXPECT_TRUE(DiskGuard(nullptr, 1).CheckSpace(1).ok());
  EXPECT_TRUE(DiskGuard(FreeOnDisk("/no/such/directory"), 1).CheckSpace(1).ok());
}

TEST(DiskGuard, ADatabaseIsAskedNowAndThen) {
  int64_t bytes = 600;
  int asked = 0;
  const auto fill = [&]() -> absl::StatusOr<DatabaseFill> {
    ++asked;
    return DatabaseFill{.bytes = bytes};
  };
  const DiskGuard often(FreeInDatabase(fill, 1'000, std::chrono::seconds(0)), 0);
  EXPECT_TRUE(often.CheckSpace(400).ok());
  bytes = 1'200;
  EXPECT_EQ(DetailOf(often.CheckSpace()).reason, Reason::kDiskLow);
  asked = 0;
  const DiskGuard seldom(FreeInDatabase(fill, 1'000, std::chrono::seconds(3600)), 0);
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(seldom.CheckSpace().ok());
  EXPECT_EQ(asked, 1);
}

TEST(DiskGuard, ADatabaseThatIsAwayRefusesNothing) {
  const DiskGuard guard(
      FreeInDatabase([] { return absl::StatusOr<DatabaseFill>(absl::UnavailableError("away")); },
                     1'000),
      0);
  EXPECT_TRUE(guard.CheckSpace(1).ok());
}

}  // namespace
}  // namespace slicefarm::coordinator::disk_guard_test
