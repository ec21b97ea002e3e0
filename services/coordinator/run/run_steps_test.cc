#include "services/coordinator/run/run_steps.h"

#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::coordinator::run_steps_test {
namespace {

using Step = RunSteps::Step;

class RunStepsTest : public testing::Test {
 protected:
  Step Next() { return steps_.Next(wishes_, now_us_); }
  void Take(Step step, const absl::StatusOr<bool>& succeeded) {
    EXPECT_EQ(Next(), step);
    steps_.Took(succeeded);
  }

  int64_t now_us_ = 0;
  RunRequests wishes_{/*deadline_us=*/100};
  RunSteps steps_;
};

TEST_F(RunStepsTest, TheWholeWay) {
  Take(Step::kFindCached, false);
  Take(Step::kBegin, false);
  Take(Step::kCompute, false);
  Take(Step::kKeep, true);
  EXPECT_EQ(Next(), Step::kOver);
  EXPECT_TRUE(steps_.status().ok());
}

TEST_F(RunStepsTest, ACachedResultIsTheEnd) {
  Take(Step::kFindCached, true);
  EXPECT_EQ(Next(), Step::kOver);
}

TEST_F(RunStepsTest, AFailureIsConcludedOnce) {
  Take(Step::kFindCached, false);
  Take(Step::kBegin, absl::InternalError("disk"));
  EXPECT_EQ(steps_.status().message(), "disk");
  Take(Step::kConclude, absl::InternalError("disk again"));
  EXPECT_EQ(Next(), Step::kOver);
  EXPECT_EQ(steps_.status().message(), "disk");
}

TEST_F(RunStepsTest, WhoLostTheJobDoesNothingMore) {
  Take(Step::kFindCached, false);
  Take(Step::kBegin, false);
  wishes_.Heard(absl::InternalError("says nothing of the lease"));
  EXPECT_EQ(Next(), Step::kCompute);
  wishes_.Heard(absl::AbortedError("fenced"));
  EXPECT_EQ(Next(), Step::kOver);
  steps_.Took(absl::CancelledError(""));
  EXPECT_EQ(Next(), Step::kOver) << "a conclusion would be a write";
}

TEST_F(RunStepsTest, WhatIsGivenUpDoesNotBegin) {
  wishes_.Cancel();
  Take(Step::kConclude, true);
  EXPECT_EQ(Next(), Step::kOver);
  EXPECT_TRUE(absl::IsCancelled(steps_.status()));
}

TEST_F(RunStepsTest, WhatIsOverdueDoesNotBegin) {
  Take(Step::kFindCached, false);
  now_us_ = 100;
  Take(Step::kConclude, true);
  EXPECT_EQ(Next(), Step::kOver);
}

TEST_F(RunStepsTest, ASuspectRestsBeforeItBegins) {
  JobRecord job;
  job.state = JobState::kRunning;
  job.lost_runs = kSuspectRuns;
  RunSteps suspect(LostRuns(job, /*calm_us=*/0));
  EXPECT_EQ(suspect.Next(wishes_, 0), Step::kFindCached) << "the same work may have been done";
  suspect.Took(false);
  EXPECT_EQ(suspect.Next(wishes_, 0), Step::kConclude);
  EXPECT_EQ(DetailOf(suspect.status()).reason, Reason::kJobPoisoned);

  job.state = JobState::kQueued;
  RunSteps rested(LostRuns(job, /*calm_us=*/INT64_MAX));
  rested.Took(false);
  EXPECT_EQ(rested.Next(wishes_, 0), Step::kBegin);
}

TEST_F(RunStepsTest, WhatIsMadeIsKeptEvenIfLate) {
  Take(Step::kFindCached, false);
  Take(Step::kBegin, false);
  wishes_.Cancel();
  now_us_ = 100;
  Take(Step::kCompute, false);
  Take(Step::kKeep, true);
  EXPECT_EQ(Next(), Step::kOver);
}

}  // namespace
}  // namespace slicefarm::coordinator::run_steps_test
