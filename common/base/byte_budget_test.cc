#include "common/base/byte_budget.h"

#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <thread>

namespace slicefarm::byte_budget_test {
namespace {

TEST(ByteBudget, WhatDoesNotFitWaitsForRoom) {
  ByteBudget budget(10);
  std::optional<absl::StatusOr<ByteBudget::Share>> first = budget.Take(6, {});
  const auto second = budget.Take(4, {});
  ASSERT_TRUE(second.ok());
  std::atomic<bool> polled = false;
  std::atomic<bool> had = false;
  std::thread third([&] {
    const auto share = budget.Take(5, CancelToken([&] {
                                     polled = true;
                                     return false;
                                   }));
    had = share.ok();
  });
  while (!polled) std::this_thread::yield();
  EXPECT_FALSE(had);
  first.reset();
  third.join();
  EXPECT_TRUE(had);
}

TEST(ByteBudget, MoreThanThereIsIsHadAlone) {
  ByteBudget budget(10);
  EXPECT_TRUE(budget.Take(1000, {}).ok());
  const auto all = budget.Take(1000, {});
  EXPECT_TRUE(all.ok());
  EXPECT_TRUE(absl::IsCancelled(budget.Take(1, CancelToken([] { return true; })).status()));
}

TEST(ByteBudget, WhoGivesUpKeepsNobodyWaiting) {
  ByteBudget budget(10);
  const auto some = budget.Take(5, {});
  EXPECT_FALSE(budget.Take(6, CancelToken([] { return true; })).ok());
  EXPECT_TRUE(budget.Take(5, {}).ok());
}

TEST(ByteBudget, SmallOnesDoNotOvertakeALargeOne) {
  ByteBudget budget(10);
  std::optional<absl::StatusOr<ByteBudget::Share>> some = budget.Take(5, {});
  std::atomic<bool> large_waits = false;
  std::thread large([&] {
    const auto share = budget.Take(10, CancelToken([&] {
                                     large_waits = true;
                                     return false;
                                   }));
    EXPECT_TRUE(share.ok());
  });
  while (!large_waits) std::this_thread::yield();
  EXPECT_FALSE(budget.Take(1, CancelToken([] { return true; })).ok());
  some.reset();
  large.join();
}

}  // namespace
}  // namespace slicefarm::byte_budget_test
