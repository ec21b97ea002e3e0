#include "services/coordinator/server/api/full_queues.h"

#include <gtest/gtest.h>

#include "services/coordinator/store/jobs/job_steps.h"

namespace slicefarm::coordinator::full_queues_test {
namespace {

constexpr int64_t kSecondUs = 1'000'000;

class FullQueuesTest : public testing::Test {
 protected:
  int64_t now_us_ = 5 * kSecondUs;
  FullQueues queues_{[this] { return now_us_; }};
};

TEST_F(FullQueuesTest, ARefusalHoldsForASecond) {
  queues_.Note("a", QueueFull(1'000), 1'000);
  EXPECT_EQ(queues_.Check("a"), QueueFull(1'000));
  EXPECT_TRUE(queues_.Check("b").ok());
  now_us_ += kSecondUs - 1;
  EXPECT_FALSE(queues_.Check("a").ok());
  now_us_ += 1;
  EXPECT_TRUE(queues_.Check("a").ok());
}

TEST_F(FullQueuesTest, OfAShortQueueForLess) {
  queues_.Note("a", QueueFull(20), 20);
  now_us_ += 99'999;
  EXPECT_FALSE(queues_.Check("a").ok());
  now_us_ += 1;
  EXPECT_TRUE(queues_.Check("a").ok());
}

TEST_F(FullQueuesTest, UntilAJobIsTakenAgain) {
  queues_.Note("a", QueueFull(1'000), 1'000);
  queues_.Note("b", absl::OkStatus(), 1'000);
  EXPECT_FALSE(queues_.Check("a").ok());
  queues_.Note("a", absl::OkStatus(), 1'000);
  EXPECT_TRUE(queues_.Check("a").ok());
}

TEST_F(FullQueuesTest, OtherEndsSayNothingOfTheQueue) {
  queues_.Note("a", absl::OkStatus(), 1'000);
  queues_.Note("a", RequestIdReused("x"), 1'000);
  EXPECT_TRUE(queues_.Check("a").ok());
}

}  // namespace
}  // namespace slicefarm::coordinator::full_queues_test
