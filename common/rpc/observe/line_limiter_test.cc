#include "common/rpc/observe/line_limiter.h"

#include <gtest/gtest.h>

namespace slicefarm::rpc::line_limiter_test {
namespace {

TEST(LineLimiter, LetsABurstThroughAndThenALineNowAndThen) {
  LineLimiter limiter({.burst = 3, .lines_per_s = 0.5});
  for (int i = 0; i < 3; ++i) EXPECT_EQ(limiter.Pass("broken", 10), 0);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(limiter.Pass("broken", 10.5), std::nullopt);
  EXPECT_EQ(limiter.Pass("broken", 12), 4);
  EXPECT_EQ(limiter.Pass("broken", 12), std::nullopt);
  EXPECT_EQ(limiter.Pass("broken", 1000), 1);
  EXPECT_EQ(limiter.Pass("broken", 1000), 0);
}

TEST(LineLimiter, MessagesDoNotSilenceEachOther) {
  LineLimiter limiter({.burst = 1, .lines_per_s = 1});
  EXPECT_EQ(limiter.Pass("a", 0), 0);
  EXPECT_EQ(limiter.Pass("a", 0), std::nullopt);
  EXPECT_EQ(limiter.Pass("b", 0), 0);
}

TEST(LineLimiter, TellsABoundedNumberOfMessagesApart) {
  LineLimiter limiter({.burst = 1, .lines_per_s = 1, .max_messages = 2});
  EXPECT_EQ(limiter.Pass("a", 0), 0);
  EXPECT_EQ(limiter.Pass("b", 0), 0);
  EXPECT_EQ(limiter.Pass("c", 0), 0);
  EXPECT_EQ(limiter.Pass("d", 0), std::nullopt);
  EXPECT_EQ(limiter.Pass("a", 2), 0);
}

}  // namespace
}  // namespace slicefarm::rpc::line_limiter_test
