// Tests of jobs with runs that began but did not end.
#include <gtest/gtest.h>

#include <string>
#include <thread>

#include "common/base/error.h"
#include "services/coordinator/run/lost_runs.h"
#include "services/coordinator/server/execution/job_runner_fixture_test.h"

namespace slicefarm::coordinator::job_runner_suspects_test {
namespace {

class JobRunnerSuspectsTest : public JobRunnerTest {
 protected:
  /// Submits a job with `lost_runs` runs during which its coordinator died. REQUIRES: no runner; no
  /// other job.
  std::string SubmitSuspect(const std::string& mesh, int lost_runs) {
    std::string id = Submit(mesh);
    const auto job = *jobs_->Claim("dead", NowUs(), NowUs() + kSecondUs);
    const JobUpdate last = {.state = JobState::kRunning, .lost_runs = lost_runs};
    EXPECT_TRUE(jobs_->Update({job->id, job->owner_epoch}, last, NowUs()).ok());
    EXPECT_TRUE(jobs_->Release("dead").ok());
    return id;
  }

  /// Waits until the job is in the queue but may not be claimed yet.
  void AwaitRest(const std::string& id) {
    JobRecord job;
    do {
      std::this_thread::yield();
      job = *jobs_->Get(id);
    } while (job.state != JobState::kQueued || !job.owner.empty() || job.owner_until_us <= NowUs());
  }
};

TEST_F(JobRunnerSuspectsTest, ARunThatIsKilledIsALostOne) {
  ranges_->Hold();
  const std::string id = SubmitSuspect("xx", 1);
  auto runner = Runner();
  ranges_->AwaitCall();
  EXPECT_EQ(jobs_->Get(id)->lost_runs, 2) << "as long as nothing more is heard of it";
  runner->Stop();
  EXPECT_EQ(jobs_->Get(id)->state, JobState::kQueued);
  EXPECT_EQ(jobs_->Get(id)->lost_runs, 1) << "it was handed back";
}

TEST_F(JobRunnerSuspectsTest, AJobThatMayKillItsCoordinatorRestsBeforeItRunsAgain) {
  const std::string suspect = SubmitSuspect("xx", kSuspectRuns);
  const std::string other = Submit("xxx");
  const auto runner = Runner();
  EXPECT_EQ(AwaitEnd(other).state, JobState::kSucceeded);
  AwaitRest(suspect);
  EXPECT_EQ(slicing_.runs(), 1);
  Pass(8 * kSecondUs);
  EXPECT_EQ(AwaitEnd(suspect).state, JobState::kSucceeded);
}

TEST_F(JobRunnerSuspectsTest, ASuspectBeginsOnACalmCoordinatorAlone) {
  const std::string suspect = SubmitSuspect("xx", kSuspectRuns);
  {
    const auto first = Runner("first");
    AwaitRest(suspect);
  }
  Pass(8 * kSecondUs);
  const auto young = Runner("second");
  AwaitRest(suspect);
  EXPECT_EQ(slicing_.runs(), 0);
  Pass(8 * kSecondUs);
  EXPECT_EQ(AwaitEnd(suspect).state, JobState::kSucceeded);
}

// The loss of a lease shows that something other than its jobs is wrong.
TEST_F(JobRunnerSuspectsTest, ACoordinatorThatLosesAClaimIsNotCalm) {
  const std::string suspect = SubmitSuspect("xx", kSuspectRuns);
  const auto job = *jobs_->Claim("dead", NowUs(), NowUs() + kSecondUs);
  const JobUpdate rests = {.state = JobState::kQueued,
                           .claimable_from_us = NowUs() + 10 * kSecondUs,
                           .lost_runs = kSuspectRuns};
  ASSERT_TRUE(jobs_->Update({job->id, job->owner_epoch}, rests, NowUs()).ok());
  const auto runner = Runner("me", /*jobs=*/1);
  const std::string held = SubmitHeld(*runner, "xxx");
  failing_.Fail(Call::kRenew, absl::InternalError("away"));
  AwaitCalls(Call::kRenew, 2);
  Pass(9 * kSecondUs);  // most of a lease
  while (ranges_->cancelled() == 0) std::this_thread::yield();
  failing_.Recover();
  ranges_->LetGo();
  Pass(kSecondUs);
  AwaitRest(suspect);
  Pass(8 * kSecondUs);
  EXPECT_EQ(AwaitEnd(suspect).state, JobState::kSucceeded);
  EXPECT_EQ(AwaitEnd(held).state, JobState::kSucceeded);
}

TEST_F(JobRunnerSuspectsTest, AnEndIsWrittenWhenTheStoreIsBack) {
  const auto runner = Runner();
  const std::string id = SubmitHeld(*runner);
  failing_.Fail(Call::kUpdate, MakeError(absl::StatusCode::kUnavailable, Reason::kStoreFailed,
                                         "PostgreSQL: it is starting up"));
  ranges_->LetGo();
  AwaitCalls(Call::kUpdate, 3);
  failing_.Recover();
  AwaitRest(id);
  EXPECT_EQ(jobs_->Get(id)->store_failures, 1);
  EXPECT_EQ(jobs_->Get(id)->lost_runs, 0) << "its coordinator lives";
  Pass(kSecondUs);
  EXPECT_EQ(AwaitEnd(id).state, JobState::kSucceeded);
}

TEST_F(JobRunnerSuspectsTest, AJobThatKillsItsCoordinatorsFailsInTheEnd) {
  const std::string poisoned = SubmitSuspect("xx", kMaxLostRuns);
  const std::string other = Submit("xxx");
  const auto runner = Runner();
  const JobRecord job = AwaitEnd(poisoned);
  EXPECT_EQ(job.state, JobState::kFailed);
  EXPECT_EQ(job.error->reason, "JOB_POISONED");
  EXPECT_EQ(AwaitEnd(other).state, JobState::kSucceeded);
}

}  // namespace
}  // namespace slicefarm::coordinator::job_runner_suspects_test
