#include "services/coordinator/algo/rate_limits.h"

#include <gtest/gtest.h>

namespace slicefarm::coordinator::rate_limits_test {
namespace {

constexpr int64_t kSecondUs = 1'000'000;

/// Returns how many single units Take grants if it is called a thousand times a second.
int CountIn(RateLimits& limits, int64_t per_second, int64_t from_us, int64_t seconds) {
  int passed = 0;
  for (int64_t at = from_us; at < from_us + seconds * kSecondUs; at += 1000)
    passed += limits.Take("a", per_second, 1, at) == 0;
  return passed;
}

TEST(RateLimits, KeepTheAverage) {
  RateLimits limits;
  EXPECT_EQ(CountIn(limits, 10, 0, 1), 30);            // two seconds' worth, and the second's
  EXPECT_EQ(CountIn(limits, 10, kSecondUs, 60), 600);  // and then the average
}

TEST(RateLimits, APauseGivesTwoSecondsBackAndNoMore) {
  RateLimits limits;
  CountIn(limits, 10, 0, 10);
  int passed = 0;
  for (int i = 0; i < 100; ++i) passed += limits.Take("a", 10, 1, 1000 * kSecondUs) == 0;
  EXPECT_EQ(passed, 20);
}

TEST(RateLimits, TellWhenThereIsMore) {
  RateLimits limits;
  for (const int64_t count : {1, 7, 50}) {
    const std::string name(static_cast<size_t>(count), 'x');
    int64_t wait_us = 0;
    while (wait_us == 0) wait_us = limits.Take(name, 10, count, 0);
    EXPECT_GT(limits.Take(name, 10, count, wait_us - 1), 0);
    EXPECT_EQ(limits.Take(name, 10, count, wait_us), 0);
  }
}

TEST(RateLimits, ManyAtOnceArePaidBack) {
  RateLimits limits;
  EXPECT_EQ(limits.Take("a", 10, 100, 0), 0);  // 80 more than there is
  EXPECT_GT(limits.Take("a", 10, 1, 8 * kSecondUs), 0);
  EXPECT_EQ(limits.Take("a", 10, 1, 8 * kSecondUs + 1), 0);
}

TEST(RateLimits, AreEachForItself) {
  RateLimits limits;
  while (limits.Take("a", 1, 1, 0) == 0) {
  }
  EXPECT_EQ(limits.Take("b", 1, 1, 0), 0);
}

TEST(RateLimits, AClockThatRunsBackwardsGivesNothing) {
  RateLimits limits;
  while (limits.Take("a", 1, 1, kSecondUs) == 0) {
  }
  EXPECT_GT(limits.Take("a", 1, 1, 0), 0);
}

}  // namespace
}  // namespace slicefarm::coordinator::rate_limits_test
