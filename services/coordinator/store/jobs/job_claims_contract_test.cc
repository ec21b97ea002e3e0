// Contract tests of claims and renewals of all JobStores.
#include "services/coordinator/store/jobs/job_store_kinds_test.h"

namespace slicefarm::coordinator::job_claims_contract_test {
namespace {

using namespace job_store_contract_test;  // NOLINT: the kinds of stores

class JobClaimsTest : public JobStoreTest {};

INSTANTIATE_TEST_SUITE_P(Stores, JobClaimsTest, testing::ValuesIn(kStores),
                         [](const auto& info) { return info.param.name; });

TEST_P(JobClaimsTest, ClaimsOldestFirstAndOnce) {
  for (const char* id : {"a", "b", "c"}) Make(id);
  const JobRecord first = **store_->Claim("me", 10, 100);
  EXPECT_EQ(first.id, "a");
  EXPECT_EQ(first.owner, "me");
  EXPECT_EQ(first.owner_epoch, 1);
  EXPECT_EQ((*store_->Claim("me", 10, 100))->id, "b");
  EXPECT_EQ((*store_->Claim("you", 10, 100))->id, "c");
  EXPECT_EQ(*store_->Claim("you", 10, 100), std::nullopt);
}

TEST_P(JobClaimsTest, ClaimsPassOverLowerPriorities) {
  for (const auto& [id, priority] :
       {std::pair{"bulk", Priority::kBulk}, {"normal", Priority::kNormal}}) {
    NewJob job = JobOf(id);
    job.priority = priority;
    ASSERT_TRUE(store_->Create(job, 1).ok());
  }
  EXPECT_EQ(*store_->Claim("me", 10, 100, {Priority::kInteractive}), std::nullopt);
  EXPECT_EQ((*store_->Claim("me", 10, 100, {Priority::kNormal}))->id, "normal");
  EXPECT_EQ(*store_->Claim("me", 10, 100, {Priority::kNormal}), std::nullopt);
  EXPECT_EQ((*store_->Claim("me", 10, 100))->id, "bulk");
}

TEST_P(JobClaimsTest, ClaimsForIdleTenantsPassOverThoseWhoseJobsAreHeld) {
  for (const char* id : {"a1", "a2", "b1", "b2"}) {
    NewJob job = JobOf(id);
    job.tenant = job.id.substr(0, 1);
    ASSERT_TRUE(store_->Create(job, 1).ok());
  }
  const ClaimFilter idle = {.of_idle_tenants = true};
  EXPECT_EQ((*store_->Claim("me", 10, 100))->id, "a1");
  EXPECT_EQ((*store_->Claim("me", 10, 50, idle))->id, "b1");
  EXPECT_EQ(*store_->Claim("me", 10, 100, idle), std::nullopt);
  EXPECT_EQ((*store_->Claim("me", 50, 60, idle))->id, "b1") << "nobody holds it any more";
  EXPECT_EQ((*store_->Claim("me", 50, 100))->id, "a2");
}

TEST_P(JobClaimsTest, ClaimsPassOverWorkThatSomebodyHolds) {
  for (const char* id : {"a", "a again", "b"}) {
    NewJob job = JobOf(id);
    if (job.id == "a again") job.action_digest = "action-a";
    ASSERT_TRUE(store_->Create(job, 1).ok());
  }
  EXPECT_EQ((*store_->Claim("me", 10, 100))->id, "a");
  EXPECT_EQ((*store_->Claim("you", 10, 200))->id, "b");
  EXPECT_EQ(*store_->Claim("you", 99, 200), std::nullopt);
  EXPECT_EQ((*store_->Claim("you", 100, 150))->id, "a") << "nobody holds it any more";
  ASSERT_TRUE(store_->Update({"a", 2}, {.state = kFailed}, 120).ok());
  EXPECT_EQ((*store_->Claim("me", 120, 200))->id, "a again");
  EXPECT_EQ(*store_->Claim("me", 120, 200), std::nullopt);
}

// The owner of the job died before it could end the job. The job need not wait for the end of the
// other one.
TEST_P(JobClaimsTest, AJobThatIsToBeCancelledWaitsForNoEqualWork) {
  for (const char* id : {"a", "a again", "a once more"}) {
    NewJob job = JobOf(id);
    job.action_digest = "action-a";
    ASSERT_TRUE(store_->Create(job, 1).ok());
  }
  ASSERT_EQ((*store_->Claim("me", 10, 100))->id, "a");
  ASSERT_TRUE(store_->RequestCancel("a", 11).ok());
  ASSERT_EQ((*store_->Claim("you", 12, 500))->id, "a again");
  EXPECT_EQ(*store_->Claim("you", 99, 500), std::nullopt);
  const auto cancelled = *store_->Claim("you", 101, 500);
  ASSERT_TRUE(cancelled);
  EXPECT_EQ(cancelled->id, "a");
  EXPECT_TRUE(cancelled->cancel_requested);
  EXPECT_EQ(store_->Update({"a", cancelled->owner_epoch}, {.state = kQueued}, 102)->state,
            JobState::kCancelled);
  EXPECT_EQ(*store_->Claim("you", 103, 500), std::nullopt) << "the third one waits for the work";
}

TEST_P(JobClaimsTest, WorkOfAJobThatIsToBeCancelledIsNotHeld) {
  for (const char* id : {"a", "a again", "b"}) {
    NewJob job = JobOf(id);
    if (job.id == "a again") job.action_digest = "action-a";
    ASSERT_TRUE(store_->Create(job, 1).ok());
  }
  ASSERT_EQ((*store_->Claim("me", 10, 100))->id, "a");
  ASSERT_TRUE(store_->RequestCancel("a", 11).ok());
  EXPECT_EQ((*store_->Claim("you", 12, 50))->id, "a again");
  const Lease b = {(*store_->Claim("you", 12, 100))->id, 1};
  EXPECT_FALSE(*store_->Adopt(b, {"settings", "action-a", "build 2"}, 13)) << "`a again` is held";
  EXPECT_TRUE(*store_->Adopt(b, {"settings", "action-a", "build 2"}, 60)) << "its lease is over";
}

TEST_P(JobClaimsTest, EqualWorkRacedByManyIsHeldOnce) {
  constexpr int kJobs = 40;
  for (int i = 0; i < kJobs; ++i) {
    NewJob job = JobOf(absl::StrCat("job", i));
    job.tenant = absl::StrCat("tenant", i % 3);
    job.action_digest = absl::StrCat("action ", i % 4);
    ASSERT_TRUE(store_->Create(job, 1).ok());
  }
  const auto other = location_->Open();
  std::mutex mutex;
  std::map<std::string, int> holders;  // number of held jobs by work
  const auto count = [&](const std::string& work, int more) {
    const std::lock_guard lock(mutex);
    return holders[work] += more;
  };
  std::atomic<int> ended = 0;
  Race(/*threads=*/6, [&](int thread) {
    JobStore& store = thread % 2 == 0 ? *store_ : *other;
    while (ended < kJobs) {
      const auto job = store.Claim(absl::StrCat("owner", thread), 10'000'000, 20'000'000);
      ASSERT_TRUE(job.ok()) << job.status();
      if (!*job) continue;
      EXPECT_EQ(count((*job)->action_digest, 1), 1);
      const Lease lease = {(*job)->id, (*job)->owner_epoch};
      ASSERT_TRUE(store.Update(lease, {.state = kRunning}, 10'000'000).ok());
      count((*job)->action_digest, -1);  // before another thread can claim the work
      ASSERT_TRUE(store.Update(lease, {.state = kFailed}, 10'000'000).ok());
      ++ended;
    }
  });
}

TEST_P(JobClaimsTest, AnotherBuildAdoptsAJobItHolds) {
  Make("a");
  const JobIdentity identity = {"settings 2", "action 2", "build 2"};
  EXPECT_TRUE(absl::IsAborted(store_->Adopt({"a", 0}, identity, now_).status()))
      << "nobody holds it";
  const Lease lease = Claim();
  EXPECT_TRUE(*store_->Adopt(lease, identity, now_));
  const JobRecord job = *store_->Get("a");
  EXPECT_EQ(job.settings_digest, "settings 2");
  EXPECT_EQ(job.build_id, "build 2");
  ASSERT_TRUE(Update(lease, kRunning).ok());
  ASSERT_TRUE(Succeed(lease, ResultOf("g", "r")).ok());
  EXPECT_TRUE(store_->FindResult("action 2")->has_value());
  EXPECT_FALSE(store_->FindResult("action-a")->has_value()) << "that is another build's";
  EXPECT_TRUE(absl::IsAborted(store_->Adopt(lease, identity, now_).status())) << "it has ended";
}

TEST_P(JobClaimsTest, WhoAdoptsWorkThatSomebodyHoldsIsTold) {
  Make("a");
  Make("b");
  const Lease a = Claim("me");
  const Lease b = Claim("you");
  const JobIdentity identity = {"settings 2", "action 2", "build 2"};
  EXPECT_TRUE(*store_->Adopt(a, identity, now_));
  EXPECT_FALSE(*store_->Adopt(b, identity, now_));
  EXPECT_EQ(store_->Get("b")->action_digest, "action 2");
  ASSERT_TRUE(Update(b, kQueued).ok());
  EXPECT_EQ(*store_->Claim("you", now_, now_ + 1000), std::nullopt) << "that is its work now";
}

TEST_P(JobClaimsTest, AChoreIsOneCallersAtATime) {
  const auto other = location_->Open();
  EXPECT_TRUE(*store_->TakeChore("sweep", 100, 200));
  EXPECT_FALSE(*other->TakeChore("sweep", 199, 299));
  EXPECT_TRUE(*other->TakeChore("other", 199, 299));
  EXPECT_TRUE(*other->TakeChore("sweep", 200, 300));
  EXPECT_FALSE(*store_->TakeChore("sweep", 200, 300));
}

TEST_P(JobClaimsTest, UseGoesOnOverShortBreaksAndForAllWhoShareTheStore) {
  constexpr int64_t kGap = 50;
  const auto other = location_->Open();
  EXPECT_EQ(*store_->InUseSince(100, kGap), 100);
  EXPECT_EQ(*other->InUseSince(150, kGap), 100);
  EXPECT_EQ(*store_->InUseSince(200, kGap), 100);
  EXPECT_EQ(*other->InUseSince(251, kGap), 251);
  EXPECT_EQ(*store_->InUseSince(251, kGap), 251);
}

// A spec may have a MiB, and no writer to a job needs it.
TEST_P(JobClaimsTest, WritesComeWithoutTheSpec) {
  Make("a");
  const std::string spec = JobOf("a").spec;
  const auto claimed = store_->Claim("me", now_, now_ + 1000);
  EXPECT_EQ((*claimed)->spec, spec);
  EXPECT_EQ(Update({"a", 1}, kRunning)->spec, "");
  EXPECT_EQ(store_->RequestCancel("a", ++now_)->spec, "");
  EXPECT_EQ(store_->Get("a")->spec, spec);
  EXPECT_EQ(store_->List({})->at(0).spec, spec);
}

TEST_P(JobClaimsTest, TwoStoresShareTheJobs) {
  const auto other = location_->Open();
  constexpr int kJobs = 60;
  for (int i = 0; i < kJobs; ++i) Make(absl::StrCat("job", i));
  std::vector<std::string> claimed[2];
  std::vector<std::thread> threads;
  for (int i = 0; i < 2; ++i) {
    threads.emplace_back([&, i] {
      JobStore& store = i == 0 ? *store_ : *other;
      while (true) {
        const auto job = store.Claim(absl::StrCat("owner", i), 10'000'000, 20'000'000);
        if (!job.ok() || !*job) return;
        claimed[i].push_back((*job)->id);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  std::set<std::string> all(claimed[0].begin(), claimed[0].end());
  all.insert(claimed[1].begin(), claimed[1].end());
  EXPECT_EQ(all.size(), static_cast<size_t>(kJobs));
  EXPECT_EQ(claimed[0].size() + claimed[1].size(), static_cast<size_t>(kJobs)) << "none twice";
}

// The lease expires before its owner has read the job.
TEST_P(JobClaimsTest, EpochsAreOneClaimersHoweverShortTheLease) {
  for (const std::string_view id : {"a", "b", "c"}) Make(std::string(id));
  std::mutex mutex;
  std::set<Lease> given;
  std::atomic<int64_t> clock = 1'000'000'000;
  Race(/*threads=*/8, [&](int thread) {
    for (int i = 0; i < 40; ++i) {
      const int64_t now_us = clock++;
      const auto job = store_->Claim(absl::StrCat("owner", thread), now_us, now_us + 1);
      ASSERT_TRUE(job.ok()) << job.status();
      if (!*job) continue;
      EXPECT_EQ((*job)->owner, absl::StrCat("owner", thread));
      std::lock_guard<std::mutex> lock(mutex);
      EXPECT_TRUE(given.insert({(*job)->id, (*job)->owner_epoch}).second) << (*job)->id;
    }
  });
  EXPECT_FALSE(given.empty());
}

// SLICEFARM_RACE_JOBS sets the number of jobs, for example 1000.
TEST_P(JobClaimsTest, ClaimsRacedByManyAreOneAnEpoch) {
  constexpr int kThreads = 8;
  const int64_t jobs = FromEnvironment("SLICEFARM_RACE_JOBS", 60);
  for (int64_t i = 0; i < jobs; ++i) Make(absl::StrCat("job", i));
  std::mutex mutex;
  std::map<Lease, std::string> owners;  // owner of each claim
  int64_t claims = 0;
  std::atomic<int64_t> clock = 1'000'000'000;
  /// Claims jobs until none is left, but at most `limit`.
  const auto claim = [&](int64_t lease_us, int64_t limit) {
    Race(kThreads, [&](int thread) {
      const std::string owner = absl::StrCat("owner", thread);
      for (int64_t i = 0; i < limit; ++i) {
        const int64_t now_us = clock++;
        const auto job = store_->Claim(owner, now_us, now_us + lease_us);
        ASSERT_TRUE(job.ok()) << job.status();
        if (!*job) return;
        std::lock_guard<std::mutex> lock(mutex);
        owners.emplace(Lease{(*job)->id, (*job)->owner_epoch}, owner);
        ++claims;
      }
    });
  };
  claim(/*lease_us=*/1'000'000, /*limit=*/INT64_MAX);
  EXPECT_EQ(claims, jobs);
  EXPECT_EQ(std::ssize(owners), jobs);
  clock += 1'000'000;  // all leases expire
  claim(/*lease_us=*/1'000'000, /*limit=*/INT64_MAX);
  EXPECT_EQ(claims, 2 * jobs);
  clock += 1'000'000;
  // These leases expire in the middle of the race.
  claim(/*lease_us=*/jobs / 2, /*limit=*/jobs / 4);
  EXPECT_EQ(std::ssize(owners), claims) << "each epoch of a job was given to one claimer";
  for (int64_t i = 0; i < jobs; ++i) {
    const auto job = store_->Get(absl::StrCat("job", i));
    ASSERT_TRUE(job.ok()) << job.status();
    const auto last = owners.find({job->id, job->owner_epoch});
    ASSERT_NE(last, owners.end());
    EXPECT_EQ(last->second, job->owner);
    EXPECT_FALSE(owners.contains({job->id, job->owner_epoch + 1}));
  }
}

TEST_P(JobClaimsTest, AnOwnerThatDoesNotRenewLosesItsJobs) {
  Make("a");
  const auto mine = store_->Claim("me", 10, 100);
  EXPECT_EQ(*store_->Claim("you", 99, 200), std::nullopt);
  const std::vector<Lease> leases = {{"a", (*mine)->owner_epoch}};
  ASSERT_THAT(*store_->Renew(leases, 150), SizeIs(1));
  EXPECT_EQ(*store_->Claim("you", 149, 200), std::nullopt);
  const auto yours = store_->Claim("you", 150, 250);
  ASSERT_NE(*yours, std::nullopt);
  EXPECT_THAT(*store_->Renew(leases, 300), IsEmpty());
  EXPECT_EQ(store_->Get("a")->owner_until_us, 250);

  const absl::Status fenced = Update({"a", (*mine)->owner_epoch}, kRunning).status();
  EXPECT_TRUE(absl::IsAborted(fenced)) << fenced;
  EXPECT_TRUE(Update({"a", (*yours)->owner_epoch}, kRunning).ok());
}

TEST_P(JobClaimsTest, LostRunsAreThoseOfTheLastWrite) {
  Make("a");
  const auto write = [&](const JobUpdate& update) {
    return store_->Update(Claim(), update, ++now_).ok() && store_->Release("me").ok();
  };
  ASSERT_TRUE(write({.state = kRunning, .lost_runs = 5}));
  EXPECT_EQ(store_->Get("a")->lost_runs, 5) << "nothing more was heard of it";
  ASSERT_TRUE(write({.state = kQueued, .lost_runs = 4}));
  EXPECT_EQ(store_->Get("a")->lost_runs, 4) << "it was handed back";
  Claim();
  ASSERT_TRUE(store_->Release("me").ok());
  EXPECT_EQ(store_->Get("a")->lost_runs, 4) << "it did not begin";
}

TEST_P(JobClaimsTest, DeadlyRunsAreCountedUntilAnotherBuildAdopts) {
  Make("a");
  const JobUpdate deadly = {.state = kQueued, .deadly = true};
  for (int i = 1; i <= 2; ++i) {
    ASSERT_TRUE(store_->Update(Claim(), deadly, ++now_).ok());
    EXPECT_EQ(store_->Get("a")->deadly_runs, i);
    EXPECT_EQ(store_->Get("a")->retries, 0);
  }
  ASSERT_TRUE(store_->Update(Claim(), {.state = kQueued, .retry = true}, ++now_).ok());
  EXPECT_EQ(store_->Get("a")->deadly_runs, 2) << "another failure says nothing of it";
  ASSERT_TRUE(store_->Adopt(Claim(), {"settings", "action", "build 2"}, now_).ok());
  EXPECT_EQ(store_->Get("a")->deadly_runs, 0);
}

TEST_P(JobClaimsTest, LostRunsAreKeptUntilAnotherBuildAdopts) {
  Make("a");
  const Lease lease = Claim();
  const JobUpdate begins = {.state = kRunning, .lost_runs = 4};
  ASSERT_TRUE(store_->Update(lease, begins, ++now_).ok());
  ASSERT_TRUE(store_->Release("me").ok());
  const Lease again = Claim();
  EXPECT_EQ(store_->Get("a")->lost_runs, 4);
  ASSERT_TRUE(store_->Adopt(again, {"settings", "action", "build 2"}, now_).ok());
  EXPECT_EQ(store_->Get("a")->lost_runs, 0);
}

TEST_P(JobClaimsTest, WhatWaitsEndsAtItsDeadline) {
  const auto make = [&](const std::string& id, int64_t deadline_us) {
    NewJob job = JobOf(id);
    job.deadline_us = deadline_us;
    ASSERT_TRUE(store_->Create(job, 1).ok());
  };
  make("held", 50);
  ASSERT_EQ((*store_->Claim("me", 10, 100))->id, "held");
  make("died", 50);  // its owner died before the job began
  ASSERT_EQ((*store_->Claim("gone", 10, 50))->id, "died");
  make("died running", 50);
  const auto ran = *store_->Claim("gone", 10, 40);
  ASSERT_EQ(ran->id, "died running");
  ASSERT_TRUE(store_->Update({ran->id, ran->owner_epoch}, {.state = kRunning}, 13).ok());
  make("cancelled", 50);
  ASSERT_EQ((*store_->Claim("you", 10, 100))->id, "cancelled");
  ASSERT_TRUE(store_->RequestCancel("cancelled", 11).ok());
  ASSERT_TRUE(store_->Release("you").ok());
  make("later", 51);
  make("second", 50);
  make("first", 49);
  make("without", kNoDeadlineUs);

  const JobError error{absl::StatusCode::kDeadlineExceeded, "DEADLINE_EXCEEDED", "late", {}};
  const auto ended = [&](int32_t limit) {
    std::vector<std::string> ids;
    const auto jobs = store_->EndOverdue(error, 50, limit);
    for (const JobRecord& job : *jobs) ids.push_back(job.id);
    return ids;
  };
  EXPECT_THAT(ended(1), ElementsAre("first"));
  EXPECT_THAT(ended(10), ElementsAre("died", "died running", "second"));
  EXPECT_THAT(ended(10), IsEmpty());
  const JobRecord job = *store_->Get("second");
  EXPECT_EQ(job.state, JobState::kFailed);
  EXPECT_EQ(job.error, error);
  EXPECT_EQ(job.end_us, 50);
  EXPECT_EQ(store_->Events("second", 1, 10)->back().state, JobState::kFailed);
  for (const char* id : {"held", "cancelled", "later", "without"}) {
    EXPECT_EQ(store_->Get(id)->state, JobState::kQueued) << id;
  }
}

TEST_P(JobClaimsTest, ALateRenewalShortensNoClaim) {
  Make("a");
  ASSERT_NE(*store_->Claim("me", 10, 100), std::nullopt);
  ASSERT_THAT(*store_->Renew({{"a", 1}}, 200), SizeIs(1));
  EXPECT_THAT(*store_->Renew({{"a", 1}}, 150), SizeIs(1));
  EXPECT_EQ(store_->Get("a")->owner_until_us, 200);
}

TEST_P(JobClaimsTest, AJobThatItsOwnerGaveUpIsClaimedAgain) {
  Make("given up");
  Make("kept");
  for (int i = 0; i < 2; ++i) ASSERT_NE(*store_->Claim("me", 10, 100), std::nullopt);
  ASSERT_THAT(*store_->Renew({{"kept", 1}}, 200), SizeIs(1));
  EXPECT_EQ((*store_->Claim("me", 100, 300))->id, "given up");
  EXPECT_EQ(*store_->Claim("me", 100, 300), std::nullopt);
  EXPECT_THAT(*store_->Renew({{"given up", 1}, {"kept", 1}}, 400), SizeIs(1)) << "of the old claim";
}

TEST_P(JobClaimsTest, ReleasedJobsAreClaimedAgain) {
  Make("a");
  const Lease old = Claim("me");
  ASSERT_TRUE(Update(old, kRunning).ok());
  ASSERT_TRUE(store_->Release("me").ok());
  EXPECT_THAT(*store_->Renew({old}, now_ + 1000), IsEmpty());
  EXPECT_TRUE(absl::IsAborted(Update(old, kRunning).status()));
  const auto again = store_->Claim("me", now_, now_ + 10);
  ASSERT_NE(*again, std::nullopt);
  EXPECT_EQ((*again)->state, kRunning);
  EXPECT_EQ((*again)->owner_epoch, old.epoch + 1);
}

}  // namespace
}  // namespace slicefarm::coordinator::job_claims_contract_test
