#include "services/coordinator/run/run_conclusion.h"

#include <gtest/gtest.h>

#include <string>

#include "common/base/error.h"

namespace slicefarm::coordinator::run_conclusion_test {
namespace {

using enum JobState;

constexpr int64_t kNowUs = 1'000'000'000;

absl::Status Away() { return absl::UnavailableError("away"); }
absl::Status NoStage() {
  return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable, "no planning service",
                   {{"stage", "planning"}});
}
absl::Status StoreFailed() {
  return MakeError(absl::StatusCode::kInternal, Reason::kStoreFailed, "disk I/O error");
}

absl::Status LostStage() {
  return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable, "slicing was lost",
                   {{"lost", "connection"}});
}
absl::Status RangePoisoned(const std::string& cause) {
  return MakeError(absl::StatusCode::kInternal, Reason::kRangePoisoned, "", {{"cause", cause}});
}
absl::Status JobPoisoned() {
  return MakeError(absl::StatusCode::kInternal, Reason::kJobPoisoned, "");
}

struct Case {
  std::string name;
  absl::Status error;
  int retries;
  int store_failures;
  JobState state;
  int64_t delay_us;
  int lost_runs = 0;
  int deadly_runs = 0;
};

class ConclusionTest : public testing::TestWithParam<Case> {};

TEST_P(ConclusionTest, OfAnErrorAfterEarlierOnes) {
  const Case& c = GetParam();
  JobRecord job;
  job.retries = c.retries;
  job.store_failures = c.store_failures;
  job.lost_runs = c.lost_runs;
  job.deadly_runs = c.deadly_runs;
  job.state = kRunning;
  const JobUpdate update =
      Conclusion(job, LostRuns(job, 0), RunRequests(), c.error, {9, 4}, kNowUs);
  EXPECT_EQ(update.state, c.state);
  EXPECT_EQ(update.layers_total, 9);
  if (c.state == kQueued) {
    EXPECT_EQ(update.claimable_from_us, kNowUs + c.delay_us);
    EXPECT_EQ(update.layers_done, 0);
  } else {
    EXPECT_EQ(update.error, JobErrorOf(c.error));
    EXPECT_EQ(update.layers_done, 4);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Errors, ConclusionTest,
    testing::Values(
        Case{"FirstTimeAway", Away(), 0, 0, kQueued, 500'000},
        Case{"FifthTimeAway", Away(), 4, 9, kQueued, 8'000'000},
        Case{"SixthTimeAway", Away(), 5, 0, kFailed, 0},
        Case{"OfAnotherBuild",
             MakeError(absl::StatusCode::kFailedPrecondition, Reason::kBuildMismatch, ""), 5, 9,
             kQueued, 5'000'000},
        Case{"StoreFails", StoreFailed(), 5, 0, kQueued, 500'000},
        Case{"StoreFailsStill", StoreFailed(), 5, 1000, kQueued, 60'000'000},
        Case{"DiskFull", MakeError(absl::StatusCode::kResourceExhausted, Reason::kDiskFull, ""), 5,
             9, kQueued, 10'000'000},
        Case{"ARangeKillsItsWorkers", RangePoisoned("UNAVAILABLE"), 5, 9, kQueued, 8'000'000, 2},
        Case{"ARangeKillsThemAgain", RangePoisoned("UNAVAILABLE"), 0, 0, kQueued, 64'000'000, 9, 1},
        Case{"ARangeKillsThemAtLast", RangePoisoned("UNAVAILABLE"), 0, 0, kFailed, 0, 0, 2},
        Case{"ARangeFailsItsWorkers", RangePoisoned("INTERNAL"), 0, 0, kFailed, 0},
        Case{"ThirdCoordinatorDies", JobPoisoned(), 9, 0, kQueued, 4'000'000, 3},
        Case{"NinthCoordinatorDies", JobPoisoned(), 9, 0, kQueued, 256'000'000, 9},
        Case{"TenthCoordinatorDies", JobPoisoned(), 0, 0, kFailed, 0, 10},
        Case{"NoServerOfAStage", NoStage(), 0, 0, kQueued, 1'000'000},
        Case{"NoServerOfAStageForLong", NoStage(), 5, 9, kQueued, 1'000'000, 9, 2},
        Case{"AStageIsLost", LostStage(), 5, 9, kQueued, 8'000'000},
        Case{"AStageIsLostAgain", LostStage(), 0, 0, kQueued, 64'000'000, 0, 1},
        Case{"AStageIsLostAtLast", LostStage(), 0, 0, kFailed, 0, 0, 2},
        Case{"AJobThatServicesDiedOfRests", JobPoisoned(), 0, 0, kQueued, 64'000'000, 1, 2},
        Case{"ItIsAwayBesides", Away(), 4, 0, kQueued, 8'000'000, 0, 2},
        Case{"InputAtFault", absl::InvalidArgumentError("bad mesh"), 0, 0, kFailed, 0}),
    [](const auto& info) { return info.param.name; });

TEST(Conclusion, WhatAFailureCountsAs) {
  const JobUpdate away = Conclusion({}, {}, RunRequests(), Away(), {}, kNowUs);
  EXPECT_TRUE(away.retry);
  EXPECT_FALSE(away.store_failed);
  EXPECT_FALSE(Conclusion({}, {}, RunRequests(), NoStage(), {}, kNowUs).retry);
  const JobUpdate store = Conclusion({}, {}, RunRequests(), StoreFailed(), {}, kNowUs);
  EXPECT_FALSE(store.retry);
  EXPECT_TRUE(store.store_failed);
  const JobUpdate deadly = Conclusion({}, {}, RunRequests(), LostStage(), {}, kNowUs);
  EXPECT_TRUE(deadly.deadly);
  EXPECT_FALSE(deadly.retry);
  EXPECT_FALSE(away.deadly);
  const absl::Status misfit =
      MakeError(absl::StatusCode::kFailedPrecondition, Reason::kBuildMismatch, "");
  EXPECT_FALSE(Conclusion({}, {}, RunRequests(), misfit, {}, kNowUs).retry);
}

TEST(Conclusion, WishesComeBeforeErrors) {
  RunRequests wishes;
  wishes.HandBack();
  JobRecord job;
  job.retries = 5;
  const JobUpdate back = Conclusion(job, {}, wishes, Away(), {}, kNowUs);
  EXPECT_EQ(back.state, kQueued);
  EXPECT_EQ(back.claimable_from_us, kNowUs);
  EXPECT_FALSE(back.retry);
  wishes.Cancel();
  EXPECT_EQ(Conclusion(job, {}, wishes, Away(), {}, kNowUs).state, kCancelled);
}

TEST(Conclusion, ADeadlineComesBeforeErrorsAndAfterOtherWishes) {
  RunRequests wishes(/*deadline_us=*/kNowUs);
  EXPECT_EQ(Conclusion({}, {}, wishes, Away(), {}, kNowUs - 1).state, kQueued);
  const JobUpdate late = Conclusion({}, {}, wishes, Away(), {9, 4}, kNowUs);
  EXPECT_EQ(late.state, kFailed);
  EXPECT_EQ(late.layers_done, 4);
  EXPECT_EQ(late.error->reason, "DEADLINE_EXCEEDED");
  wishes.HandBack();
  EXPECT_EQ(Conclusion({}, {}, wishes, Away(), {}, kNowUs).state, kQueued);
}

}  // namespace
}  // namespace slicefarm::coordinator::run_conclusion_test
