#include "services/coordinator/algo/job_state.h"

#include <gtest/gtest.h>

#include <array>

namespace slicefarm::coordinator::job_state_test {
namespace {

using enum JobState;
constexpr std::array kAll = {kQueued, kRunning, kSucceeded, kFailed, kCancelled};

TEST(JobState, EndsOnce) {
  for (const JobState from : kAll) {
    for (const JobState to : kAll) {
      if (IsTerminal(from) || from == to) {
        EXPECT_FALSE(MayFollow(from, to));
      } else if (IsTerminal(to)) {
        EXPECT_TRUE(MayFollow(from, to));
      }
    }
  }
}

TEST(JobState, RunsAndIsHandedBack) {
  EXPECT_TRUE(MayFollow(kQueued, kRunning));
  EXPECT_TRUE(MayFollow(kRunning, kQueued));
}

TEST(JobState, NamesLeadBack) {
  for (const JobState state : kAll) EXPECT_EQ(JobStateFromName(JobStateName(state)), state);
  EXPECT_EQ(JobStateFromName("ASLEEP"), std::nullopt);
}

}  // namespace
}  // namespace slicefarm::coordinator::job_state_test
