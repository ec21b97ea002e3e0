#include "services/coordinator/server/api/queue_view.h"

#include <gmock/gmock.h>
#include <google/protobuf/util/time_util.h>
#include <gtest/gtest.h>

#include <atomic>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/rpc/event_test.h"
#include "services/coordinator/store/jobs/forwarding_job_store.h"
#include "tests/support/memory_job_store.h"

namespace slicefarm::coordinator::queue_view_test {
namespace {

constexpr int64_t kSecond = 1'000'000;
constexpr int64_t kLease = 3600 * kSecond;

/// Store that counts reads of the queue. It can fail or delay them.
class LookedAtStore : public ForwardingJobStore {
 public:
  using ForwardingJobStore::ForwardingJobStore;
  absl::StatusOr<QueueSnapshot> ReadQueue(int64_t now_us) override {
    ++looks;
    if (go_on) go_on->Await();
    if (fails) return MakeError(absl::StatusCode::kUnavailable, Reason::kStoreFailed, "away");
    return store().ReadQueue(now_us);
  }
  std::atomic<int> looks = 0;
  bool fails = false;
  Event* go_on = nullptr;
};

class QueueViewTest : public testing::Test {
 protected:
  void Make(const std::string& id, const std::string& work = "") {
    NewJob job;
    job.id = id;
    job.action_digest = work.empty() ? "work of " + id : work;
    ASSERT_TRUE(memory_.Create(job, now_us_).ok());
  }

  Lease Begin() {
    const auto job = *memory_.Claim("me", now_us_, now_us_ + kLease);
    const Lease lease = {job->id, job->owner_epoch};
    EXPECT_TRUE(memory_.Update(lease, {.state = JobState::kRunning}, now_us_).ok());
    return lease;
  }

  void End(const Lease& lease, JobState state = JobState::kFailed) {
    EXPECT_TRUE(memory_.Update(lease, {.state = state}, now_us_).ok());
  }

  /// Makes three jobs with this run time.
  void MakeRuns(int64_t run_us) {
    for (int i = 0; i < 3; ++i) {
      Make(absl::StrCat("before ", i));
      const Lease lease = Begin();
      now_us_ += run_us;
      End(lease);
    }
  }

  v1::Job Describe(const std::string& id) { return Describe(*memory_.Get(id)); }
  v1::Job Describe(const JobRecord& job) {
    v1::Job answer;
    view_.Describe(job, answer);
    return answer;
  }

  /// Returns the expected end in seconds from now; -1 if the job has none.
  double EndOf(const v1::Job& job) const {
    if (!job.has_estimated_end_time()) return -1;
    const auto us =
        google::protobuf::util::TimeUtil::TimestampToMicroseconds(job.estimated_end_time());
    return static_cast<double>(us - now_us_) / kSecond;
  }

  MemoryJobs jobs_;
  MemoryJobStore memory_{jobs_};
  LookedAtStore store_{memory_};
  std::atomic<int64_t> now_us_ = 1'000 * kSecond;
  QueueView view_{store_, [this] { return now_us_.load(); }};
};

TEST_F(QueueViewTest, TellsPlaceAndEnd) {
  MakeRuns(10 * kSecond);
  for (const char* id : {"running", "first", "second"}) Make(id);
  Begin();
  now_us_ += 4 * kSecond;
  EXPECT_EQ(Describe("running").queue_position(), 0);
  EXPECT_EQ(EndOf(Describe("running")), 6);
  EXPECT_EQ(Describe("first").queue_position(), 1);
  EXPECT_EQ(EndOf(Describe("first")), 16);
  EXPECT_EQ(Describe("second").queue_position(), 2);
  EXPECT_EQ(EndOf(Describe("second")), 26);
}

TEST_F(QueueViewTest, TellsNothingOfWhatIsNotKnown) {
  Make("running", "work");
  Make("same", "work");
  Make("again");
  Make("waiting");
  const Lease running = Begin();
  const Lease again = Begin();
  ASSERT_EQ(again.job_id, "again");
  EXPECT_TRUE(
      memory_
          .Update(
              again,
              {.state = JobState::kQueued, .claimable_from_us = now_us_ + kLease, .retry = true},
              now_us_)
          .ok());
  EXPECT_EQ(Describe("same").queue_position(), 0) << "waits for the same work";
  EXPECT_EQ(Describe("again").queue_position(), 0) << "waits for its next attempt";
  EXPECT_GT(Describe("waiting").queue_position(), 0);
  EXPECT_EQ(EndOf(Describe("waiting")), -1) << "no run has ended";
  EXPECT_EQ(EndOf(Describe("running")), -1);
  End(running);
  EXPECT_EQ(EndOf(Describe("running")), -1) << "it ended";
}

TEST_F(QueueViewTest, TellsNoEndWhileNothingRuns) {
  MakeRuns(10 * kSecond);
  Make("waiting");
  EXPECT_EQ(Describe("waiting").queue_position(), 1);
  EXPECT_EQ(EndOf(Describe("waiting")), -1);
}

TEST_F(QueueViewTest, LayersTellTheEnd) {
  MakeRuns(10 * kSecond);
  Make("a");
  Begin();
  now_us_ += 30 * kSecond;
  JobRecord job = *memory_.Get("a");
  EXPECT_EQ(EndOf(Describe(job)), -1) << "it has lasted longer than others";
  job.layers_total = 40;
  job.layers_done = 10;
  EXPECT_EQ(EndOf(Describe(job)), 90);
}

TEST_F(QueueViewTest, AStoreThatFailsOrStandsStillTellsNothing) {
  Make("a");
  store_.fails = true;
  EXPECT_EQ(Describe("a").queue_position(), 0);
  store_.fails = false;
  Event go_on;
  store_.go_on = &go_on;
  EXPECT_EQ(Describe("a").queue_position(), 0);
  go_on.Happen();
  while (Describe("a").queue_position() == 0) continue;  // the read that was in progress ends first
  EXPECT_EQ(Describe("a").queue_position(), 1);
}

TEST_F(QueueViewTest, AskingOfManyTakesFewLooks) {
  constexpr int kJobs = 2'000;
  for (int i = 0; i < kJobs; ++i) Make(absl::StrCat(i));
  for (int i = 0; i < kJobs; i += 20) EXPECT_EQ(Describe(absl::StrCat(i)).queue_position(), i + 1);
  EXPECT_LT(store_.looks, kJobs / 20 / 4);
}

}  // namespace
}  // namespace slicefarm::coordinator::queue_view_test
