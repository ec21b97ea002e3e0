// Contract tests of the queue of all JobStores: jobs are claimed in the order that the queue shows.
#include "services/coordinator/store/jobs/job_store_kinds_test.h"

namespace slicefarm::coordinator::job_queue_contract_test {
namespace {

using namespace job_store_contract_test;  // NOLINT: the kinds of stores

class JobQueueTest : public JobStoreTest {
 protected:
  void MakeFor(const std::string& tenant, Priority priority, int64_t deadline_us = kNoDeadlineUs) {
    NewJob job = JobOf(absl::StrCat("job ", ++made_));
    job.tenant = tenant;
    job.priority = priority;
    job.deadline_us = deadline_us;
    ASSERT_TRUE(store_->Create(job, ++now_).ok());
  }

  /// Claims all jobs as one coordinator does. Before each claim, ends the job that has run longest.
  /// Returns the numbers of the jobs.
  std::vector<int64_t> ServeAll(std::vector<Lease> held) {
    std::vector<int64_t> numbers;
    while (!held.empty()) {
      now_ += kRunUs;
      EXPECT_TRUE(Update(held.front(), kFailed).ok());
      held.erase(held.begin());
      ++now_;
      const auto job = store_->Claim("me", now_, now_ + kLongUs);
      EXPECT_TRUE(job.ok()) << job.status();
      if (!job.ok() || !*job) continue;
      numbers.push_back((*job)->number);
      held.push_back({(*job)->id, (*job)->owner_epoch});
    }
    return numbers;
  }

  std::vector<Lease> Begin(int count) {
    std::vector<Lease> held;
    for (int i = 0; i < count; ++i) {
      ++now_;
      const auto job = *store_->Claim("me", now_, now_ + kLongUs);
      held.push_back({job->id, job->owner_epoch});
      EXPECT_TRUE(Update(held.back(), kRunning).ok());
    }
    return held;
  }

  static constexpr int64_t kLongUs = 1'000'000'000;
  static constexpr int64_t kRunUs = 1'000'000;
  int made_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Stores, JobQueueTest, testing::ValuesIn(kStores),
                         [](const auto& info) { return info.param.name; });

TEST_P(JobQueueTest, IsEmptyWithoutOpenJobs) {
  MakeDone("a", ResultOf("g", "r"));
  EXPECT_EQ(store_->ReadQueue(now_)->held, std::vector<HeldSlot>());
  EXPECT_EQ(store_->ReadQueue(now_)->tenants, std::vector<TenantQueue>());
}

TEST_P(JobQueueTest, TellsWhatIsHeldAndWhatWaits) {
  MakeFor("a", Priority::kBulk);                        // 1
  MakeFor("a", Priority::kNormal);                      // 2
  MakeFor("a", Priority::kNormal, now_ + 2 * kLongUs);  // 3: comes before 2
  MakeFor("b", Priority::kInteractive);                 // 4
  const Lease held = Begin(1).front();
  const auto queue = *store_->ReadQueue(now_);
  ASSERT_THAT(queue.held, SizeIs(1));
  EXPECT_EQ(queue.held[0].tenant, "a");
  EXPECT_EQ(queue.held[0].owner, "me");
  EXPECT_FALSE(queue.held[0].interactive);
  EXPECT_GT(queue.held[0].start_us, 0);
  EXPECT_THAT(queue.held_work, ElementsAre("action-" + held.job_id));
  ASSERT_THAT(queue.tenants, SizeIs(2));
  EXPECT_EQ(queue.tenants[0].waiting, (std::vector<WaitingJob>{{2, false}, {1, false}}));
  EXPECT_GT(queue.tenants[0].turn_us, 0);
  EXPECT_EQ(queue.tenants[1], (TenantQueue{"b", 0, {{4, true}}}));
  EXPECT_THAT(store_->ReadQueue(now_ + 2 * kLongUs)->held, IsEmpty()) << "its lease is over";
}

TEST_P(JobQueueTest, TimesOfRunsAreThoseOfTheLatestThatBegan) {
  Make("cancelled");
  ASSERT_TRUE(store_->RequestCancel("cancelled", ++now_).ok());
  for (const char* id : {"a", "b"}) Make(id);
  for (int i = 0; i < 2; ++i) {
    const Lease lease = Claim();
    ASSERT_TRUE(Update(lease, kRunning).ok());
    now_ += 100 + i;
    ASSERT_TRUE(Update(lease, kFailed).ok());
  }
  EXPECT_THAT(store_->ReadQueue(now_)->runs_us, ElementsAre(102, 101));
}

// The test has several priorities, deadlines and slots, and tenants with many jobs and with few.
TEST_P(JobQueueTest, IsServedInTheOrderThatIsExpected) {
  for (const int slots : {1, 2, 3, 5}) {
    for (int i = 0; i < 40; ++i) {
      const std::string tenant = absl::StrCat("t", i % 7 == 0 ? 1 : i % 3 == 0 ? 2 : 3);
      const Priority priority = i % 5 == 0 ? Priority::kBulk : Priority::kNormal;
      MakeFor(tenant, priority, i % 4 == 0 ? 50 * kLongUs - i : kNoDeadlineUs);
    }
    const std::vector<Lease> held = Begin(slots);
    std::vector<int64_t> expected;
    for (const ExpectedRun& run : ExpectedRuns(*store_->ReadQueue(now_), now_))
      expected.push_back(run.number);
    ASSERT_THAT(expected, SizeIs(40 - slots));
    EXPECT_EQ(ServeAll(held), expected) << slots << " slots";
  }
}

}  // namespace
}  // namespace slicefarm::coordinator::job_queue_contract_test
