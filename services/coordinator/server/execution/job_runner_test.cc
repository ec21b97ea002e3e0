// Tests of job runs with real stores and fake stages, without a server.
#include "services/coordinator/server/execution/job_runner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <thread>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/stage/exposure_job.h"
#include "common/stage/exposure_stage.h"
#include "processes/laser/model/exposed_program.h"
#include "processes/laser/model/exposure_settings.h"
#include "services/coordinator/server/execution/job_runner_fixture_test.h"

namespace slicefarm::coordinator::job_runner_test {
namespace {

// The ranges of both jobs share the workers.
TEST_F(JobRunnerTest, AJobOfAnIdleTenantDoesNotWaitForTheEndOfOthers) {
  const auto runner = Runner("me", /*jobs=*/1);
  ranges_->Hold();
  const auto submit = [&](const std::string& mesh, const std::string& tenant) {
    const std::string id = Submit(mesh, "build", kNoDeadlineUs, tenant);
    runner->Wake();
    return id;
  };
  const auto state = [&](const std::string& id) { return jobs_->Get(id)->state; };
  const std::string long_one = submit("aa", "a");
  ranges_->AwaitCall();
  const std::string next = submit("ab", "a");
  std::vector<std::string> of_others;
  for (const char* tenant : {"b", "c", "d"}) of_others.push_back(submit("xx", tenant));
  for (const std::string& id : of_others)
    while (state(id) != JobState::kRunning) std::this_thread::yield();
  EXPECT_EQ(state(long_one), JobState::kRunning);
  EXPECT_EQ(state(next), JobState::kQueued) << "more of the same tenant wait for its end";
  ranges_->LetGo();
  for (const std::string& id : of_others) EXPECT_EQ(AwaitEnd(id).state, JobState::kSucceeded);
  EXPECT_EQ(AwaitEnd(next).state, JobState::kSucceeded);
}

TEST_F(JobRunnerTest, RunsManyJobs) {
  const auto runner = Runner();
  std::vector<std::string> ids;
  for (int i = 1; i <= 20; ++i) {
    ids.push_back(Submit(std::string(i, 'x')));
    runner->Wake();
  }
  for (int i = 1; i <= 20; ++i) {
    const JobRecord job = AwaitEnd(ids[i - 1]);
    EXPECT_EQ(job.state, JobState::kSucceeded);
    EXPECT_EQ(job.result->layers, i);
  }
}

TEST_F(JobRunnerTest, JobsOfTheSameWorkLeaveRoomForOthers) {
  const auto runner = Runner();
  const std::string first = SubmitHeld(*runner);
  const std::string same = Submit("xx");
  const std::string other = Submit("xxx");
  runner->Wake();
  while (jobs_->Get(other)->state != JobState::kRunning && jobs_->Get(same)->owner.empty()) {
    std::this_thread::yield();
  }
  EXPECT_EQ(jobs_->Get(other)->state, JobState::kRunning);
  EXPECT_EQ(jobs_->Get(same)->owner, "") << "it waits in the queue";
  ranges_->LetGo();
  EXPECT_FALSE(AwaitEnd(first).result->cached);
  EXPECT_TRUE(AwaitEnd(same).result->cached);
  EXPECT_EQ(AwaitEnd(other).state, JobState::kSucceeded);
  EXPECT_EQ(slicing_.runs(), 2);
}

TEST_F(JobRunnerTest, ProgressIsToldAndNotWritten) {
  const auto runner = Runner();
  const std::string id = Submit(std::string(20'000, 'x'));
  std::atomic<int> reported = 0;
  const int64_t ticket =
      feed_.Listen(id, [&](JobFeed::News news) { reported += news == JobFeed::News::kProgress; });
  runner->Wake();
  EXPECT_EQ(AwaitEnd(id).state, JobState::kSucceeded);
  feed_.Forget(ticket);
  EXPECT_GE(reported, 1);
  EXPECT_LE(reported, 101) << "not layer by layer";
  EXPECT_EQ(jobs_->Events(id, 0, 10'000)->size(), 3u) << "queued, running, succeeded";
}

TEST_F(JobRunnerTest, ARequestToCancelIsFoundInTheStore) {
  const auto runner = Runner();
  const std::string id = SubmitHeld(*runner);
  // The client of another coordinator cancels the job.
  ASSERT_TRUE(jobs_->RequestCancel(id, NowUs()).ok());
  EXPECT_EQ(AwaitEnd(id).state, JobState::kCancelled);
}

// At this time, no other thread can notify the run.
TEST_F(JobRunnerTest, ACancelBetweenTheClaimAndTheRunIsHeeded) {
  const auto runner = Runner();
  failing_.Fail(Call::kRenew, absl::InternalError("away"));
  failing_.Block(Call::kUpdate);
  ranges_->Hold();
  const std::string id = Submit("xx");
  runner->Wake();
  AwaitCalls(Call::kUpdate, 1);
  ASSERT_TRUE(jobs_->RequestCancel(id, NowUs()).ok());
  failing_.Unblock(Call::kUpdate);
  EXPECT_EQ(AwaitEnd(id).state, JobState::kCancelled);
}

TEST_F(JobRunnerTest, AJobThatIsToEndDoesNotEndWithAnEarlierResult) {
  const std::string id = Submit("xx");
  ASSERT_NE(*jobs_->Claim("dead", NowUs(), NowUs() + kSecondUs), std::nullopt);
  ASSERT_TRUE(jobs_->RequestCancel(id, NowUs()).ok());
  const auto runner = Runner();
  const std::string same = Submit("xx");
  runner->Wake();
  EXPECT_EQ(AwaitEnd(same).state, JobState::kSucceeded);
  Pass(kSecondUs);
  EXPECT_EQ(AwaitEnd(id).state, JobState::kCancelled);
}

TEST_F(JobRunnerTest, MeshesThatAreSlicedMakeRoomForOthers) {
  memory_ = std::make_unique<MemoryBudget>(3);
  const auto runner = Runner();
  const std::string held = SubmitHeld(*runner, "xx");
  // Does not fit into memory beside the first job, and cannot be sliced.
  const std::string other = Submit("x!");
  runner->Wake();
  EXPECT_EQ(AwaitEnd(other).state, JobState::kFailed);
  ranges_->LetGo();
  EXPECT_EQ(AwaitEnd(held).state, JobState::kSucceeded);
}

TEST_F(JobRunnerTest, NoJobBeginsAsLongAsStagesAreOfAnotherBuild) {
  slicing_.mismatches_ = 1;
  Unfit(Process::kFdm) = true;
  const auto runner = Runner();
  const std::string met = Submit("?");
  runner->Wake();
  while (asked_ == 0) std::this_thread::yield();
  const std::string other = Submit("xx");
  runner->Wake();
  Pass(60 * kSecondUs);
  for (const int until = asked_ + 5; asked_ < until;) std::this_thread::yield();
  EXPECT_EQ(jobs_->Get(other)->state, JobState::kQueued);
  EXPECT_EQ(slicing_.runs(), 1) << "the run that met them";
  Unfit(Process::kFdm) = false;
  EXPECT_EQ(AwaitEnd(other).state, JobState::kSucceeded);
  EXPECT_EQ(AwaitEnd(met).state, JobState::kSucceeded);
}

/// Stage of laser jobs that is never reached, because slicing fails before.
class UnusedExposure : public ExposureStage {
 public:
  absl::StatusOr<std::vector<ExposedProgram>> Expose(const StageCall&, const Neighbourhood&,
                                                     const Shared<ExposureJob>&) const override {
    return absl::UnimplementedError("");
  }
  absl::StatusOr<ExposureEnvelope> Envelope(const StageCall&, const ExposureSummary&,
                                            const ExposureSettings&) const override {
    return absl::UnimplementedError("");
  }
};

class JobRunnerProcessesTest : public JobRunnerTest {
 protected:
  JobRunnerProcessesTest() : JobRunnerTest(&exposure_stage_) {}

  std::string SubmitLaser(const std::string& mesh) {
    return Submit(mesh, "build", kNoDeadlineUs, "", v1::PROCESS_LASER);
  }

  const UnusedExposure exposure_stage_;
};

TEST_F(JobRunnerProcessesTest, JobsOfAProcessWithoutItsStagesHoldUpNoOthers) {
  slicing_.mismatches_ = 1;
  Unfit(Process::kLaser) = true;
  const auto runner = Runner();
  const std::string met = SubmitLaser("?");
  runner->Wake();
  while (asked_ == 0) std::this_thread::yield();
  const std::string laser = SubmitLaser("!");
  const std::string other = Submit("xx");  // it is claimed after the older one
  runner->Wake();
  EXPECT_EQ(AwaitEnd(other).state, JobState::kSucceeded);
  EXPECT_EQ(jobs_->Get(laser)->state, JobState::kQueued);
  EXPECT_EQ(jobs_->Get(laser)->start_us, 0) << "it began in vain";
  EXPECT_EQ(slicing_.runs(), 2) << "the run that met them, and the other process";
  ASSERT_TRUE(jobs_->RequestCancel(met, NowUs()).ok());
  Unfit(Process::kLaser) = false;
  Pass(60 * kSecondUs);
  EXPECT_EQ(AwaitEnd(laser).state, JobState::kFailed) << "it cannot be sliced";
}

TEST_F(JobRunnerTest, NoJobBeginsWithoutRoomForItsResult) {
  room_ = false;
  const auto runner = Runner();
  const std::string job = Submit("xx");
  runner->Wake();
  for (const int until = asked_for_room_ + 5; asked_for_room_ < until;) std::this_thread::yield();
  EXPECT_EQ(jobs_->Get(job)->state, JobState::kQueued);
  EXPECT_EQ(slicing_.runs(), 0);
  room_ = true;
  EXPECT_EQ(AwaitEnd(job).state, JobState::kSucceeded);
}

/// Returns a memory value of this process from /proc, in bytes. "VmRSS:" is the current memory,
/// "VmHWM:" is the largest memory since the last call of ForgetMost.
int64_t Memory(const std::string& what) {
  std::ifstream status("/proc/self/status");
  for (std::string key; status >> key;) {
    int64_t kib = 0;
    if (key == what && status >> kib) return kib << 10;
  }
  return 0;
}
bool ForgetMost() {
  return static_cast<bool>(std::ofstream("/proc/self/clear_refs") << "5" << std::flush);
}

TEST_F(JobRunnerTest, AProgramNeedNotFitIntoMemory) {
  constexpr int kLayers = 1'000;
  constexpr int64_t kBytesALayer = 128 << 10;
  ranges_->bytes_a_layer_ = kBytesALayer;
  if (!ForgetMost()) GTEST_SKIP() << "this system does not tell how much memory was taken";
  const int64_t before = Memory("VmRSS:");
  const auto runner = Runner();
  const std::string id = Submit(std::string(kLayers, 'x'));
  runner->Wake();
  const JobRecord job = AwaitEnd(id);
  ASSERT_EQ(job.state, JobState::kSucceeded);
  EXPECT_GT(job.result->gcode_size, kLayers * kBytesALayer);
  // The memory holds one range of at most 128 layers for each of the two slots.
  EXPECT_LT(Memory("VmHWM:") - before, kLayers * kBytesALayer / 2);
}

TEST_F(JobRunnerTest, AJobThatDoesNotFitIntoMemoryFails) {
  memory_ = std::make_unique<MemoryBudget>(3);
  const auto runner = Runner();
  const std::string large = Submit("xxxx");
  const std::string small = Submit("xxx");
  runner->Wake();
  const JobRecord job = AwaitEnd(large);
  EXPECT_EQ(job.state, JobState::kFailed);
  EXPECT_EQ(job.error->reason, "REQUEST_TOO_LARGE");
  EXPECT_EQ(job.error->metadata.at("limit"), "3");
  EXPECT_EQ(job.error->metadata.at("got"), "4");
  EXPECT_EQ(AwaitEnd(small).state, JobState::kSucceeded);
}

TEST_F(JobRunnerTest, AJobThatWaitsEndsAtItsDeadline) {
  const auto runner = Runner();
  const std::string held = SubmitHeld(*runner);
  // Waits for the end of the same work.
  const std::string same = Submit("xx", "build", NowUs() + kSecondUs);
  Pass(kSecondUs);
  const JobRecord job = AwaitEnd(same);
  EXPECT_EQ(job.state, JobState::kFailed);
  EXPECT_EQ(job.error->reason, "DEADLINE_EXCEEDED");
  EXPECT_EQ(jobs_->Get(held)->state, JobState::kRunning);
}

TEST_F(JobRunnerTest, AFencedRunWritesNothing) {
  const auto runner = Runner("me");
  const std::string id = SubmitHeld(*runner);
  // Another coordinator claims the job, as if this one had been silent for too long.
  const int64_t later_us = NowUs() + 3600 * kSecondUs;
  const auto taken = jobs_->Claim("you", later_us, later_us + 60 * kSecondUs);
  ASSERT_NE(*taken, std::nullopt);
  ranges_->LetGo();
  runner->Stop();
  const JobRecord job = *jobs_->Get(id);
  EXPECT_EQ(job.state, JobState::kRunning);
  EXPECT_EQ(job.owner, "you");
  EXPECT_EQ(job.last_sequence, (*taken)->last_sequence);
}

TEST_F(JobRunnerTest, AJobGivenUpWhileTheStoreWasAwayIsClaimedAgain) {
  const auto runner = Runner();
  const std::string id = SubmitHeld(*runner);
  failing_.Fail(Call::kRenew, absl::InternalError("away"));
  AwaitCalls(Call::kRenew, 2);  // a renewal that was in flight before has now been answered
  const int64_t until_us = jobs_->Get(id)->owner_until_us;
  now_us_ = until_us - kSecondUs;
  while (ranges_->cancelled() == 0) std::this_thread::yield();

  failing_.Recover();
  AwaitCalls(Call::kRenew, 2);
  ASSERT_EQ(jobs_->Get(id)->owner_until_us, until_us) << "what nobody works on is not held";
  ranges_->LetGo();
  now_us_ = until_us;
  EXPECT_EQ(AwaitEnd(id).state, JobState::kSucceeded);
  EXPECT_EQ(jobs_->Get(id)->owner_epoch, 2);
}

TEST_F(JobRunnerTest, ARenewalWithoutAnAnswerKeepsNoRunGoing) {
  const auto runner = Runner();
  const std::string id = SubmitHeld(*runner);
  failing_.Block(Call::kRenew);
  AwaitCalls(Call::kRenew, 1);
  const int64_t until_us = jobs_->Get(id)->owner_until_us;
  now_us_ = until_us - kSecondUs;
  while (ranges_->cancelled() == 0) std::this_thread::yield();

  failing_.Recover();
  ranges_->LetGo();
  now_us_ = 2 * until_us;
  EXPECT_EQ(AwaitEnd(id).state, JobState::kSucceeded);
  EXPECT_EQ(jobs_->Get(id)->owner_epoch, 2);
}

TEST_F(JobRunnerTest, AShortAbsenceOfTheStoreCostsNothing) {
  const auto runner = Runner();
  const std::string id = SubmitHeld(*runner);
  failing_.Fail(Call::kRenew, absl::InternalError("away"));
  AwaitCalls(Call::kRenew, 2);
  now_us_ = jobs_->Get(id)->owner_until_us - 3 * kSecondUs;
  AwaitCalls(Call::kRenew, 2);
  failing_.Recover();
  AwaitCalls(Call::kRenew, 2);
  ranges_->LetGo();
  EXPECT_EQ(AwaitEnd(id).state, JobState::kSucceeded);
  EXPECT_EQ(jobs_->Get(id)->owner_epoch, 1);
}

TEST_F(JobRunnerTest, AStoreThatFailsDelaysAJobAndNeverEndsIt) {
  failing_.Fail(Call::kFindResult, MakeError(absl::StatusCode::kInternal, Reason::kStoreFailed,
                                             "SQLite: disk I/O error"));
  const std::string id = Submit("xx");
  const auto runner = Runner();
  int64_t last_delay_us = 0;
  for (int failures = 1; failures <= 9; ++failures) {
    JobRecord job = *jobs_->Get(id);
    while (!IsTerminal(job.state) && job.store_failures < failures) {
      std::this_thread::yield();
      job = *jobs_->Get(id);
    }
    ASSERT_EQ(job.state, JobState::kQueued);
    const int64_t delay_us = job.owner_until_us - NowUs();
    EXPECT_GE(delay_us, std::min(2 * last_delay_us, 60 * kSecondUs));
    EXPECT_LE(delay_us, 60 * kSecondUs);
    last_delay_us = delay_us;
    if (failures == 9) failing_.Recover();
    Pass(delay_us);
  }
  const JobRecord job = AwaitEnd(id);
  EXPECT_EQ(job.state, JobState::kSucceeded);
  EXPECT_EQ(job.retries, 0) << "those are for services that are not there";
}

TEST_F(JobRunnerTest, WhatAnEarlierLifeLeftGoesOn) {
  const std::string id = Submit("xxx");
  const auto claimed = jobs_->Claim("me", NowUs(), NowUs() + 3'600'000'000);
  ASSERT_TRUE(
      jobs_->Update({id, (*claimed)->owner_epoch}, {.state = JobState::kRunning}, NowUs()).ok());
  const auto runner = Runner("me");
  EXPECT_EQ(AwaitEnd(id).state, JobState::kSucceeded);
}

TEST_F(JobRunnerTest, StopHandsBack) {
  auto runner = Runner();
  const std::string id = SubmitHeld(*runner, "xxx");
  runner->Stop();
  const JobRecord job = *jobs_->Get(id);
  EXPECT_EQ(job.state, JobState::kQueued);
  EXPECT_EQ(job.owner, "");
  EXPECT_EQ(job.retries, 0);
  ranges_->LetGo();
  runner = Runner();
  EXPECT_EQ(AwaitEnd(id).state, JobState::kSucceeded);
}

TEST_F(JobRunnerTest, AJobOfAnotherBuildIsFiledUnderThisOne) {
  const std::string theirs = Submit("xx", "another build");
  const auto runner = Runner();
  const JobRecord first = AwaitEnd(theirs);
  EXPECT_EQ(first.state, JobState::kSucceeded);
  EXPECT_EQ(first.build_id, "build");
  const JobRecord ours = AwaitEnd(Submit("xx"));
  EXPECT_EQ(ours.action_digest, first.action_digest);
  EXPECT_TRUE(ours.result->cached);
  EXPECT_TRUE(AwaitEnd(Submit("xx", "a third build")).result->cached);
  EXPECT_EQ(slicing_.runs(), 1);
}

TEST_F(JobRunnerTest, JobsOfAnotherBuildWaitForTheSameWorkOfThisOne) {
  const auto runner = Runner();
  const std::string ours = SubmitHeld(*runner);
  const std::string theirs = Submit("xx", "another build");
  runner->Wake();
  while (jobs_->Get(theirs)->build_id != "build") std::this_thread::yield();
  ranges_->LetGo();
  EXPECT_FALSE(AwaitEnd(ours).result->cached);
  EXPECT_TRUE(AwaitEnd(theirs).result->cached);
  EXPECT_EQ(slicing_.runs(), 1);
}

TEST_F(JobRunnerTest, AnEndThatCannotBeWrittenComesAgain) {
  const auto runner = Runner();
  const std::string id = SubmitHeld(*runner);
  failing_.Fail(Call::kUpdate, absl::InternalError("away"));
  ranges_->LetGo();
  runner->Stop();
  failing_.Recover();
  EXPECT_EQ(jobs_->Get(id)->state, JobState::kRunning);
  now_us_ = jobs_->Get(id)->owner_until_us;
  const auto other = Runner("you");
  EXPECT_EQ(AwaitEnd(id).state, JobState::kSucceeded);
  EXPECT_EQ(jobs_->Get(id)->owner_epoch, 2);
}

TEST_F(JobRunnerTest, AStageOfAnotherBuildNeverEndsAJob) {
  slicing_.mismatches_ = 12;
  const std::string id = Submit("x?");
  const auto runner = Runner();
  for (JobRecord job = *jobs_->Get(id); !IsTerminal(job.state); job = *jobs_->Get(id)) {
    // The clock advances only to the job's next claim, which may be in progress already. A larger
    // step would let its lease expire.
    now_us_ = std::max(NowUs(), job.owner.empty() ? job.owner_until_us : 0);
    runner->Wake();
    std::this_thread::yield();
  }
  EXPECT_EQ(jobs_->Get(id)->state, JobState::kSucceeded);
  EXPECT_EQ(jobs_->Get(id)->retries, 0) << "so that there are some left for stages that are away";
}

TEST_F(JobRunnerTest, AStageThatStaysAwayFailsTheJobInTheEnd) {
  slicing_.unavailable_ = 1000;
  const std::string id = Submit("x~");
  // These tries simulate earlier runs.
  for (int i = 0; i < 5; ++i) {
    const auto claimed = jobs_->Claim("past", NowUs(), NowUs() + 1'000'000);
    ASSERT_TRUE(
        jobs_->Update({id, (*claimed)->owner_epoch}, {.state = JobState::kRunning}, NowUs()).ok());
    JobUpdate back{.state = JobState::kQueued};
    back.retry = true;
    ASSERT_TRUE(jobs_->Update({id, (*claimed)->owner_epoch}, back, NowUs()).ok());
  }
  const auto runner = Runner();
  const JobRecord job = AwaitEnd(id);
  EXPECT_EQ(job.state, JobState::kFailed);
  EXPECT_EQ(job.error->reason, "UNAVAILABLE");
}

}  // namespace
}  // namespace slicefarm::coordinator::job_runner_test
