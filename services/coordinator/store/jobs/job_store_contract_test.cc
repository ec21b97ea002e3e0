// Contract tests of all JobStores. An entry in kStores adds an implementation.
#include "services/coordinator/store/jobs/job_store_kinds_test.h"

namespace slicefarm::coordinator::job_store_contract_test {
namespace {

INSTANTIATE_TEST_SUITE_P(Stores, JobStoreTest, testing::ValuesIn(kStores),
                         [](const auto& info) { return info.param.name; });

TEST_P(JobStoreTest, GivesBackWhatWasCreated) {
  const auto created = store_->Create(JobOf("a"), 42);
  ASSERT_TRUE(created.ok()) << created.status();
  EXPECT_TRUE(created->fresh);
  auto job = store_->Get("a");
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(*job, created->job);
  EXPECT_EQ(job->state, kQueued);
  EXPECT_EQ(job->spec, JobOf("a").spec) << "with the zero in it";
  EXPECT_EQ(job->labels, JobOf("a").labels);
  EXPECT_EQ(job->action_digest, "action-a");
  EXPECT_EQ(job->create_us, 42);
  EXPECT_EQ(job->last_sequence, 1);
  job->spec.clear();
  EXPECT_EQ(*store_->GetWithoutSpec("a"), *job);
}

TEST_P(JobStoreTest, SurvivesBeingOpenedAgain) {
  Make("a");
  const auto before = store_->Get("a");
  store_.reset();
  store_ = location_->Open();
  EXPECT_EQ(*store_->Get("a"), *before);
}

TEST_P(JobStoreTest, UnknownJobsAreNotFound) {
  for (const absl::Status& status :
       {store_->Get("x").status(), store_->GetWithoutSpec("x").status(),
        store_->RequestCancel("x", 1).status(), store_->Delete("x"),
        store_->Events("x", 0, 9).status(), store_->Update({"x", 1}, {}, 1).status()}) {
    EXPECT_EQ(DetailOf(status).reason, Reason::kJobNotFound) << status;
  }
}

TEST_P(JobStoreTest, RequestIdMakesOneJob) {
  NewJob first = JobOf("a");
  first.request_id = "r";
  ASSERT_TRUE(store_->Create(first, 1).ok());
  NewJob again = JobOf("b");
  again.request_id = "r";
  again.spec_digest = first.spec_digest;
  const auto second = store_->Create(again, 2);
  ASSERT_TRUE(second.ok()) << second.status();
  EXPECT_FALSE(second->fresh);
  EXPECT_EQ(second->job.id, "a");
  EXPECT_TRUE(absl::IsNotFound(store_->Get("b").status()));
}

TEST_P(JobStoreTest, RequestIdIsNotForAnotherJob) {
  NewJob first = JobOf("a");
  first.request_id = "r";
  ASSERT_TRUE(store_->Create(first, 1).ok());
  NewJob other = JobOf("b");
  other.request_id = "r";
  EXPECT_EQ(DetailOf(store_->Create(other, 2).status()).reason, Reason::kRequestIdReused);
}

TEST_P(JobStoreTest, MakesAllJobsOrNone) {
  std::vector<NewJob> jobs = {JobOf("a"), JobOf("b"), JobOf("c")};
  jobs[2].request_id = "taken";
  NewJob other = JobOf("other");
  other.request_id = "taken";
  ASSERT_TRUE(store_->Create(other, 1).ok());
  EXPECT_EQ(DetailOf(store_->CreateAll(jobs, 2).status()).reason, Reason::kRequestIdReused);
  jobs[2].request_id = "r";
  jobs[2].refusal = absl::NotFoundError("no mesh");
  EXPECT_TRUE(absl::IsNotFound(store_->CreateAll(jobs, 2).status()));
  jobs[2].refusal = absl::OkStatus();
  for (NewJob& job : jobs) job.max_open = 3;
  EXPECT_EQ(DetailOf(store_->CreateAll(jobs, 2).status()).reason, Reason::kQueueFull)
      << "with the one that there is they are four";
  EXPECT_TRUE(absl::IsNotFound(store_->Get("a").status()));
  for (NewJob& job : jobs) job.max_open = 4;
  const auto all = store_->CreateAll(jobs, 3);
  ASSERT_TRUE(all.ok()) << all.status();
  ASSERT_THAT(*all, SizeIs(3));
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(all->at(i).fresh);
    EXPECT_EQ(all->at(i).job, *store_->Get(jobs[i].id));
  }
  EXPECT_LT(all->at(0).job.number, all->at(1).job.number);
}

TEST_P(JobStoreTest, AllJobsOfARepeatedCallAreThoseOfTheFirst) {
  std::vector<NewJob> jobs = {JobOf("a"), JobOf("b")};
  for (NewJob& job : jobs) job.request_id = "r" + job.id;
  ASSERT_TRUE(store_->CreateAll(jobs, 1).ok());
  std::vector<NewJob> again = jobs;
  for (NewJob& job : again) job.id += "'";
  const auto all = store_->CreateAll(again, 2);
  ASSERT_TRUE(all.ok()) << all.status();
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_FALSE(all->at(i).fresh);
    EXPECT_EQ(all->at(i).job.id, jobs[i].id);
  }
  EXPECT_THAT(*store_->CreateAll({}, 3), IsEmpty());
}

TEST_P(JobStoreTest, RequestIdIsForgottenAfterItsTime) {
  NewJob first = JobOf("a");
  first.request_id = "r";
  ASSERT_TRUE(store_->Create(first, 10).ok());
  NewJob other = JobOf("b");
  other.request_id = "r";
  ASSERT_TRUE(store_->ExpireRequestIds(10 + kRequestIdKeptUs).ok());
  EXPECT_FALSE(store_->Create(other, 2).ok());
  ASSERT_TRUE(store_->ExpireRequestIds(11 + kRequestIdKeptUs).ok());
  EXPECT_TRUE(store_->Create(other, 2).ok());
}

// SLICEFARM_RACE_ROUNDS sets the number of rounds, for example 10,000.
TEST_P(JobStoreTest, RequestIdRacedByManyMakesOneJob) {
  constexpr int kThreads = 64;
  const int64_t rounds = FromEnvironment("SLICEFARM_RACE_ROUNDS", 10);
  std::vector<absl::StatusOr<Created>> created(kThreads, absl::UnknownError("not called"));
  int64_t wrong = 0;
  std::barrier start(kThreads);
  std::barrier end(kThreads, [&]() noexcept {
    int fresh = 0;
    bool same = true;
    for (const auto& call : created) {
      same = same && call.ok() && created[0].ok() && call->job == created[0]->job;
      fresh += call.ok() && call->fresh ? 1 : 0;
    }
    wrong += same && fresh == 1 ? 0 : 1;
  });
  Race(kThreads, [&](int thread) {
    for (int64_t round = 0; round < rounds; ++round) {
      NewJob job = JobOf(absl::StrCat("job-", round, "-", thread));
      job.request_id = absl::StrCat("request-", round);
      job.spec_digest = "same";
      start.arrive_and_wait();
      created[thread] = store_->Create(job, 1);
      end.arrive_and_wait();
    }
  });
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(store_->CountOpen()->at(0).count, rounds);
}

TEST_P(JobStoreTest, ListsNewestFirstAndByPages) {
  for (const char* id : {"a", "b", "c", "d", "e"}) Make(id);
  std::vector<std::string> ids;
  ListQuery query{.states = {}, .after_number = 0, .limit = 2};
  while (true) {
    const auto page = store_->List(query);
    ASSERT_TRUE(page.ok()) << page.status();
    if (page->empty()) break;
    for (const JobRecord& job : *page) ids.push_back(job.id);
    query.after_number = page->back().number;
    Make(absl::StrCat("new", ids.size()));  // must not change the following pages
  }
  EXPECT_THAT(ids, ElementsAre("e", "d", "c", "b", "a"));
}

TEST_P(JobStoreTest, ListsByState) {
  MakeDone("done", ResultOf("g", "r"));
  Make("waits");
  Make("runs");
  const auto list = [&](std::vector<JobState> states) {
    std::vector<std::string> ids;
    ListQuery query;
    query.states = std::move(states);
    const auto jobs = store_->List(query);
    for (const JobRecord& job : *jobs) ids.push_back(job.id);
    return ids;
  };
  EXPECT_THAT(list({kSucceeded}), ElementsAre("done"));
  EXPECT_THAT(list({kQueued}), ElementsAre("runs", "waits"));
  EXPECT_THAT(list({kSucceeded, kQueued}), SizeIs(3));
  EXPECT_THAT(list({kFailed}), IsEmpty());
  EXPECT_THAT(*store_->CountEnded(), ElementsAre(Pair(kSucceeded, 1)));
}

TEST_P(JobStoreTest, CountsWhatIsOpenByPriority) {
  EXPECT_THAT(*store_->CountOpen(), IsEmpty());
  MakeDone("done", ResultOf("g", "r"));
  const auto make = [&](const std::string& id, Priority priority) {
    NewJob job = JobOf(id);
    job.priority = priority;
    return store_->Create(job, ++now_)->job.create_us;
  };
  const int64_t runs_since = make("runs", Priority::kInteractive);
  ASSERT_TRUE(Update(Claim(), kRunning).ok());
  const int64_t bulk_since = make("old", Priority::kBulk);
  make("younger", Priority::kBulk);
  const int64_t normal_since = make("normal", Priority::kNormal);
  EXPECT_THAT(*store_->CountOpen(),
              UnorderedElementsAre(OpenJobs{kRunning, Priority::kInteractive, 1, runs_since},
                                   OpenJobs{kQueued, Priority::kBulk, 2, bulk_since},
                                   OpenJobs{kQueued, Priority::kNormal, 1, normal_since}));
}

TEST_P(JobStoreTest, UpdatesKeepTheTimes) {
  Make("a");
  const Lease lease = Claim();
  const auto running = Update(lease, kRunning);
  ASSERT_TRUE(running.ok()) << running.status();
  const int64_t started = now_;
  const auto done = Succeed(lease, ResultOf("g", "r"));
  ASSERT_TRUE(done.ok()) << done.status();
  EXPECT_EQ(done->start_us, started);
  EXPECT_EQ(done->end_us, now_);
  EXPECT_EQ(done->result, ResultOf("g", "r"));
  EXPECT_EQ(done->owner, "");
  EXPECT_EQ(*store_->GetWithoutSpec("a"), *done);
}

TEST_P(JobStoreTest, FailuresAreKept) {
  Make("a");
  const Lease lease = Claim();
  JobUpdate update{.state = kFailed};
  update.error = JobErrorOf(MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshTruncated,
                                      "ends \"early\"\n", {{"got", "7"}}));
  ASSERT_TRUE(store_->Update(lease, update, 5).ok());
  EXPECT_EQ(store_->Get("a")->error, update.error);
}

TEST_P(JobStoreTest, EndsOnce) {
  Make("a");
  const Lease lease = Claim();
  ASSERT_TRUE(Succeed(lease, ResultOf("g", "r")).ok());
  for (const JobState state : {kQueued, kRunning, kSucceeded, kFailed, kCancelled}) {
    EXPECT_TRUE(absl::IsAborted(Update(lease, state).status()));
  }
  EXPECT_EQ(store_->Get("a")->state, kSucceeded);
}

TEST_P(JobStoreTest, HandedBackJobsWaitAsLongAsTheyShould) {
  Make("a");
  const Lease lease = Claim();
  ASSERT_TRUE(Update(lease, kRunning).ok());
  JobUpdate update{.state = kQueued};
  update.claimable_from_us = 5'000'000;
  update.retry = true;
  ASSERT_TRUE(store_->Update(lease, update, 2'000'000).ok());
  EXPECT_THAT(*store_->Renew({lease}, 9'000'000), IsEmpty());
  EXPECT_EQ(*store_->Claim("you", 4'999'999, 9'000'000), std::nullopt);
  const auto again = store_->Claim("you", 5'000'000, 9'000'000);
  ASSERT_NE(*again, std::nullopt);
  EXPECT_EQ((*again)->retries, 1);
}

TEST_P(JobStoreTest, FailuresOfTheStoreAreCountedApart) {
  Make("a");
  JobUpdate update{.state = kQueued};
  update.store_failed = true;
  ASSERT_TRUE(store_->Update(Claim(), update, ++now_).ok());
  ASSERT_TRUE(store_->Update(Claim(), update, ++now_).ok());
  EXPECT_EQ(store_->Get("a")->store_failures, 2);
  EXPECT_EQ(store_->Get("a")->retries, 0);
}

TEST_P(JobStoreTest, EventsTellTheStory) {
  Make("a");
  const Lease lease = Claim();
  ASSERT_TRUE(Update(lease, kRunning).ok());
  JobUpdate progress{.state = kRunning, .layers_total = 9, .layers_done = 4};
  ASSERT_TRUE(store_->Update(lease, progress, 77).ok());
  ASSERT_TRUE(Succeed(lease, ResultOf("g", "r")).ok());
  const auto events = store_->Events("a", 0, 100);
  ASSERT_TRUE(events.ok()) << events.status();
  ASSERT_THAT(*events, SizeIs(4));
  for (int i = 0; i < 4; ++i) EXPECT_EQ(events->at(i).sequence, i + 1);
  EXPECT_EQ(events->at(0).state, kQueued);
  EXPECT_EQ(events->at(2), (JobEventRecord{3, 77, kRunning, 9, 4}));
  EXPECT_EQ(events->at(3).state, kSucceeded);
  EXPECT_THAT(*store_->Events("a", 3, 100), SizeIs(1));
  EXPECT_THAT(*store_->Events("a", 0, 2), SizeIs(2));
  EXPECT_THAT(*store_->Events("a", 4, 100), IsEmpty());
}

TEST_P(JobStoreTest, EventsOfATenantComeInTheOrderOfTheirTimes) {
  NewJob other = JobOf("x");
  other.tenant = "other";
  ASSERT_TRUE(store_->Create(other, 1).ok());
  for (const char* id : {"a", "b", "c"}) ASSERT_TRUE(store_->Create(JobOf(id), 10).ok());
  ASSERT_TRUE(store_->RequestCancel("b", 5).ok()) << "by a clock that is behind";
  const auto ids = [](const std::vector<TenantEvent>& events) {
    std::string text;
    for (const TenantEvent& event : events)
      text += event.job_id + std::to_string(event.cursor.sequence) + " ";
    return text;
  };
  const std::string tenant = JobOf("a").tenant;
  const auto all = store_->EventsOf(tenant, {}, 100);
  ASSERT_TRUE(all.ok()) << all.status();
  EXPECT_EQ(ids(*all), "b2 a1 b1 c1 ");
  EXPECT_EQ(all->front().event, store_->Events("b", 1, 9)->front());
  const auto first = *store_->EventsOf(tenant, {}, 2);
  EXPECT_EQ(ids(first), "b2 a1 ");
  EXPECT_EQ(ids(*store_->EventsOf(tenant, first.back().cursor, 100)), "b1 c1 ");
  EXPECT_EQ(ids(*store_->EventsOf("other", {}, 100)), "x1 ");
  EXPECT_THAT(*store_->EventsOf("nobody", {}, 100), IsEmpty());
}

TEST_P(JobStoreTest, CancelOfAWaitingJobEndsIt) {
  Make("a");
  const auto job = store_->RequestCancel("a", 9);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->state, kCancelled);
  EXPECT_EQ(job->end_us, 9);
  EXPECT_EQ(*store_->Claim("me", 10, 20), std::nullopt);
  EXPECT_EQ(store_->Events("a", 0, 9)->back().state, kCancelled);
}

TEST_P(JobStoreTest, CancelOfAHeldJobIsForItsOwner) {
  Make("a");
  const Lease lease = Claim();
  EXPECT_EQ(store_->RequestCancel("a", 9)->state, kQueued);
  const auto held = store_->Renew({lease}, now_ + 1000);
  ASSERT_THAT(*held, SizeIs(1));
  EXPECT_TRUE(held->front().cancel_requested);
  EXPECT_EQ(held->front().lease, lease);
  ASSERT_TRUE(Update(lease, kCancelled).ok());
  const int64_t sequence = store_->Get("a")->last_sequence;
  EXPECT_EQ(store_->RequestCancel("a", 10)->last_sequence, sequence) << "nothing happens any more";
}

TEST_P(JobStoreTest, CancelOfAJobThatItsOwnerLeftEndsItThoughItWasAskedForBefore) {
  Make("a");
  Claim("me");
  ASSERT_EQ(store_->RequestCancel("a", 9)->state, kQueued);
  ASSERT_TRUE(store_->Release("me").ok());
  EXPECT_EQ(store_->RequestCancel("a", 10)->state, kCancelled);
}

TEST_P(JobStoreTest, AJobThatIsToEndIsNotPutBack) {
  Make("a");
  const Lease lease = Claim();
  ASSERT_TRUE(store_->RequestCancel("a", 9).ok());
  ASSERT_TRUE(Update(lease, kQueued).ok());
  EXPECT_EQ(store_->Get("a")->state, kCancelled);
  EXPECT_EQ(store_->Get("a")->end_us, now_);
  EXPECT_EQ(*store_->Claim("me", 10'000'000, 20'000'000), std::nullopt);
}

// A client that was promised a cancellation gets no print, and other jobs get no result.
TEST_P(JobStoreTest, AJobThatIsToEndDoesNotSucceed) {
  Make("a");
  const Lease lease = Claim();
  ASSERT_TRUE(Update(lease, kRunning).ok());
  ASSERT_TRUE(store_->RequestCancel("a", ++now_).ok());
  const auto ended = Succeed(lease, ResultOf("gcode", "report"));
  ASSERT_TRUE(ended.ok()) << ended.status();
  EXPECT_EQ(ended->state, kCancelled);
  EXPECT_EQ(ended->result, std::nullopt);
  EXPECT_EQ(*store_->GetWithoutSpec("a"), *ended);
  EXPECT_EQ(*store_->FindResult("action-a"), std::nullopt);
}

TEST_P(JobStoreTest, CallsAtTheSameTimeMakeNoMoreJobsThanThereMayBe) {
  std::atomic<int> made = 0;
  Race(8, [&](int thread) {
    for (int i = 0; i < 10; ++i) {
      NewJob job = JobOf(absl::StrCat(thread, "-", i));
      job.max_open = 5;
      const absl::Status created = store_->Create(job, 1).status();
      made += created.ok();
      EXPECT_TRUE(created.ok() || DetailOf(created).reason == Reason::kQueueFull) << created;
    }
  });
  EXPECT_EQ(made, 5);
}

TEST_P(JobStoreTest, FindsWhatIsLeftOfWhatCallsMade) {
  for (const char* id : {"a", "b", "c"}) {
    NewJob job = JobOf(id);
    job.request_id = absl::StrCat("request-", id);
    job.spec_digest = "spec";
    ASSERT_TRUE(store_->Create(job, ++now_).ok());
  }
  ASSERT_TRUE(store_->RequestCancel("b", ++now_).ok());
  ASSERT_TRUE(store_->Delete("b").ok());
  const std::vector<std::string> ids = {"request-a", "request-b", "request-c", "request-d"};
  const auto found = store_->FindRequested("", ids, "spec");
  ASSERT_TRUE(found.ok()) << found.status();
  EXPECT_THAT(*found, ElementsAre(testing::Field(&JobRecord::id, "a"),
                                  testing::Field(&JobRecord::id, "c")));
  EXPECT_THAT(*store_->FindRequested("another", ids, "spec"), IsEmpty());
  EXPECT_EQ(DetailOf(store_->FindRequested("", ids, "other").status()).reason,
            Reason::kRequestIdReused);
}

TEST_P(JobStoreTest, ARequestIdGoesWithItsJob) {
  NewJob job = JobOf("a");
  job.request_id = "r";
  ASSERT_TRUE(store_->Create(job, 1)->fresh);
  ASSERT_TRUE(store_->RequestCancel("a", 2).ok());
  ASSERT_TRUE(store_->Delete("a").ok());
  const auto again = store_->Create(job, 3);
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_TRUE(again->fresh);
}

TEST_P(JobStoreTest, DeleteIsForEndedJobs) {
  Make("a");
  EXPECT_EQ(DetailOf(store_->Delete("a")).reason, Reason::kJobNotFinished);
  ASSERT_TRUE(store_->RequestCancel("a", 1).ok());
  EXPECT_TRUE(store_->Delete("a").ok());
  EXPECT_TRUE(absl::IsNotFound(store_->Get("a").status()));
}

TEST_P(JobStoreTest, ResultsGoWithTheLastJobThatRefersToThem) {
  MakeDone("a", ResultOf("gcode", "report-a"));
  MakeDone("b", ResultOf("gcode", "report-b"));
  const std::set<std::string> blobs = {"gcode", "report-a", "report-b", "mesh of a", "other"};
  EXPECT_THAT(*store_->Referenced("", blobs),
              ElementsAre("gcode", "mesh of a", "report-a", "report-b"));
  ASSERT_TRUE(store_->Delete("a").ok());
  EXPECT_FALSE(store_->FindResult("action-a")->has_value());
  EXPECT_TRUE(store_->FindResult("action-b")->has_value());
  EXPECT_THAT(*store_->Referenced("", blobs), ElementsAre("gcode", "report-b"));
  ASSERT_TRUE(store_->Delete("b").ok());
  EXPECT_FALSE(store_->FindResult("action-b")->has_value());
  EXPECT_THAT(*store_->Referenced("", blobs), IsEmpty());
}

TEST_P(JobStoreTest, WhatATenantRefersToKeepsNothingOfAnothers) {
  const auto make_done = [&](const std::string& id, const std::string& tenant) {
    NewJob job = JobOf(id);
    job.tenant = tenant;
    job.inputs = {"mesh"};
    EXPECT_TRUE(store_->Create(job, ++now_).ok());
    ++now_;
    const auto claimed = *store_->Claim("me", now_, now_ + 100);
    const Lease lease{claimed->id, claimed->owner_epoch};
    EXPECT_TRUE(store_->Update(lease, {.state = JobState::kRunning}, ++now_).ok());
    JobUpdate update{.state = JobState::kSucceeded, .result = ResultOf("gcode", "report")};
    update.result->tenant = tenant;
    EXPECT_TRUE(store_->Update(lease, update, ++now_).ok());
  };
  make_done("a", "tenant-a");
  make_done("b", "tenant-b");
  const std::set<std::string> blobs = {"mesh", "gcode", "report"};
  EXPECT_THAT(*store_->Referenced("tenant-a", blobs), ElementsAre("gcode", "mesh", "report"));
  EXPECT_THAT(*store_->Referenced("", blobs), IsEmpty());
  ASSERT_TRUE(store_->Delete("a").ok());
  EXPECT_THAT(*store_->Referenced("tenant-a", blobs), IsEmpty());
  EXPECT_THAT(*store_->Referenced("tenant-b", blobs), ElementsAre("gcode", "mesh", "report"));
  EXPECT_FALSE(store_->FindResult("action-a")->has_value());
  EXPECT_TRUE(store_->FindResult("action-b")->has_value());
}

TEST_P(JobStoreTest, ListsTheJobsOfATenantOrOfAll) {
  for (const std::string tenant : {"", "a", "b"}) {
    NewJob job = JobOf("of " + tenant);
    job.tenant = tenant;
    ASSERT_TRUE(store_->Create(job, ++now_).ok());
  }
  EXPECT_EQ(store_->List({})->size(), 1u);
  EXPECT_EQ(store_->List({.tenant = "a"})->at(0).id, "of a");
  EXPECT_EQ(store_->List({.all_tenants = true})->size(), 3u);
}

TEST_P(JobStoreTest, ATraceIsKeptAndGrows) {
  Make("a");
  const Lease first = Claim();
  ASSERT_TRUE(Update(first, kRunning).ok());
  JobUpdate update;
  update.state = kQueued;
  update.trace_sha256 = "trace 1";
  EXPECT_EQ(store_->Update(first, update, ++now_)->trace_sha256, "trace 1");
  const Lease second = Claim();
  EXPECT_EQ(Update(second, kRunning)->trace_sha256, "trace 1") << "it stays";
  update.state = kFailed;
  update.trace_sha256 = "trace 2";
  ASSERT_TRUE(store_->Update(second, update, ++now_).ok());
  EXPECT_EQ(store_->Get("a")->trace_sha256, "trace 2");
  EXPECT_THAT(*store_->Referenced("", {"trace 1", "trace 2"}), ElementsAre("trace 2"));
  ASSERT_TRUE(store_->Delete("a").ok());
  EXPECT_THAT(*store_->Referenced("", {"trace 2"}), IsEmpty());
}

TEST_P(JobStoreTest, AListOfGreatJobsEndsEarly) {
  NewJob job = JobOf("big");
  job.spec = std::string(kListedSpecBytes / 2, 's');
  for (const char* id : {"1", "2", "3"}) {
    job.id = id;
    ASSERT_TRUE(store_->Create(job, ++now_).ok());
  }
  EXPECT_EQ(store_->List({.oldest_first = true})->size(), 2U);
}

TEST_P(JobStoreTest, ARefusalStandsBehindAnEarlierJob) {
  NewJob job = JobOf("a");
  job.request_id = "r";
  ASSERT_TRUE(store_->Create(job, ++now_).ok());
  job.id = "b";
  job.refusal = absl::ResourceExhaustedError("no room");
  EXPECT_EQ(store_->Create(job, ++now_)->job.id, "a");
  job.request_id = "s";
  EXPECT_TRUE(absl::IsResourceExhausted(store_->Create(job, ++now_).status()));
  job.refusal = absl::OkStatus();
  EXPECT_TRUE(store_->Create(job, ++now_)->fresh) << "what was refused took no request id";
}

TEST_P(JobStoreTest, TellsWhichJobsEndedLongAgo) {
  MakeDone("a", ResultOf("g", "r"));
  const int64_t between_us = ++now_;
  MakeDone("b", ResultOf("g", "r"));
  Make("c");
  EXPECT_THAT(*store_->EndedBefore(between_us, 10), ElementsAre("a"));
  EXPECT_THAT(*store_->EndedBefore(now_ + 1, 10), ElementsAre("a", "b"));
  EXPECT_THAT(*store_->EndedBefore(now_ + 1, 1), ElementsAre("a"));
}

TEST_P(JobStoreTest, UrgentJobsComeFirst) {
  const auto make = [&](const std::string& id, Priority priority, int64_t deadline_us) {
    NewJob job = JobOf(id);
    job.priority = priority;
    job.deadline_us = deadline_us;
    ASSERT_TRUE(store_->Create(job, ++now_).ok());
  };
  make("bulk", Priority::kBulk, 50);
  make("normal", Priority::kNormal, kNoDeadlineUs);
  make("normal soon", Priority::kNormal, 1'000'000);
  make("interactive", Priority::kInteractive, kNoDeadlineUs);
  for (const char* id : {"interactive", "normal soon", "normal", "bulk"}) {
    EXPECT_EQ(Claim().job_id, id);
  }
}

TEST_P(JobStoreTest, TenantsTakeTurns) {
  const auto make = [&](const std::string& tenant, int count) {
    for (int i = 0; i < count; ++i) {
      NewJob job = JobOf(absl::StrCat(tenant, i));
      job.tenant = tenant;
      ASSERT_TRUE(store_->Create(job, ++now_).ok());
    }
  };
  make("many", 5);
  make("few", 2);
  make("one", 1);
  std::vector<std::string> order;
  for (int i = 0; i < 8; ++i) order.push_back(Claim().job_id);
  EXPECT_THAT(order,
              ElementsAre("few0", "many0", "one0", "few1", "many1", "many2", "many3", "many4"));
}

TEST_P(JobStoreTest, ATenantWhoseJobsAreDoneIsNotBehind) {
  for (const char* id : {"a0", "a1", "b0", "b1"}) {
    NewJob job = JobOf(id);
    job.tenant = std::string(id, 1);
    ASSERT_TRUE(store_->Create(job, ++now_).ok());
  }
  const Lease first = Claim();
  EXPECT_EQ(first.job_id, "a0");
  ASSERT_TRUE(Update(first, kRunning).ok());
  ASSERT_TRUE(Succeed(first, ResultOf("g", "r")).ok());
  EXPECT_EQ(Claim().job_id, "b0") << "whose turn was longer ago";
  EXPECT_EQ(Claim().job_id, "a1") << "of which none is held";
}

TEST_P(JobStoreTest, ATenantsQueueIsBounded) {
  NewJob job = JobOf("a");
  job.max_open = 2;
  for (const char* id : {"a", "b"}) {
    job.id = id;
    ASSERT_TRUE(store_->Create(job, ++now_).ok());
  }
  job.id = "c";
  job.request_id = "again";
  const absl::Status full = store_->Create(job, ++now_).status();
  EXPECT_TRUE(absl::IsResourceExhausted(full));
  EXPECT_EQ(DetailOf(full).reason, Reason::kQueueFull);
  EXPECT_EQ(DetailOf(full).metadata["retry_after_ms"], "5000");
  job.tenant = "another";
  EXPECT_TRUE(store_->Create(job, ++now_).ok());
  job.tenant = "";
  ASSERT_TRUE(store_->RequestCancel("a", ++now_).ok());
  EXPECT_TRUE(store_->Create([&] { return job.id = "d", job; }(), ++now_)->fresh)
      << "the refused call has not used its request_id up";
}

TEST_P(JobStoreTest, RequestIdsBelongToATenant) {
  NewJob job = JobOf("a");
  job.request_id = "r";
  ASSERT_TRUE(store_->Create(job, 1).ok());
  job.id = "b";
  job.tenant = "another";
  EXPECT_TRUE(store_->Create(job, 2)->fresh);
}

TEST_P(JobStoreTest, ListsWhatIsAskedFor) {
  const auto make = [&](const std::string& id, const std::string& tenant, Priority priority,
                        std::map<std::string, std::string> labels) {
    NewJob job = JobOf(id);
    job.tenant = tenant;
    job.priority = priority;
    job.labels = std::move(labels);
    ASSERT_TRUE(store_->Create(job, now_ += 10).ok());
  };
  make("a", "", Priority::kNormal, {{"order", "1"}, {"printer", "x"}});
  make("b", "", Priority::kBulk, {{"order", "1"}});
  make("c", "", Priority::kNormal, {{"order", "2"}, {"printer", "x"}});
  make("d", "another", Priority::kNormal, {{"order", "1"}});
  const auto ids = [&](const ListQuery& query) {
    std::vector<std::string> found;
    const auto jobs = store_->List(query);
    EXPECT_TRUE(jobs.ok()) << jobs.status();
    for (const JobRecord& job : *jobs) found.push_back(job.id);
    return found;
  };
  EXPECT_THAT(ids({}), ElementsAre("c", "b", "a"));
  EXPECT_THAT(ids({.oldest_first = true}), ElementsAre("a", "b", "c"));
  EXPECT_THAT(ids({.labels = {{"order", "1"}}}), ElementsAre("b", "a"));
  EXPECT_THAT(ids({.labels = {{"order", "1"}, {"printer", "x"}}}), ElementsAre("a"));
  EXPECT_THAT(ids({.labels = {{"order", "x"}}}), IsEmpty());
  EXPECT_THAT(ids({.priority = Priority::kBulk}), ElementsAre("b"));
  EXPECT_THAT(ids({.created_from_us = now_ - 25, .created_before_us = now_ - 10}),
              ElementsAre("b"));
  EXPECT_THAT(ids({.tenant = "another"}), ElementsAre("d"));
  const int64_t b = store_->Get("b")->number;
  EXPECT_THAT(ids({.oldest_first = true, .after_number = b}), ElementsAre("c"));
  EXPECT_THAT(ids({.after_number = b}), ElementsAre("a"));
}

TEST_P(JobStoreTest, FindsResultsByContent) {
  EXPECT_FALSE(store_->FindResult("action-a")->has_value());
  MakeDone("a", ResultOf("g", "r"));
  EXPECT_EQ(*store_->FindResult("action-a"), ResultOf("g", "r"));
  ASSERT_TRUE(store_->ForgetResult("action-a").ok());
  EXPECT_FALSE(store_->FindResult("action-a")->has_value());
}

TEST_P(JobStoreTest, ACachedResultMustStillBeThere) {
  MakeDone("a", ResultOf("g", "r"));
  NewJob same = JobOf("b");
  same.action_digest = "action-a";
  ASSERT_TRUE(store_->Create(same, 1).ok());
  const Lease lease = Claim();
  JobResult cached = ResultOf("g", "r");
  cached.cached = true;

  ASSERT_TRUE(store_->Delete("a").ok());
  EXPECT_EQ(DetailOf(Succeed(lease, cached).status()).reason, Reason::kBlobNotFound);
  EXPECT_EQ(store_->Get("b")->state, kQueued);
  EXPECT_TRUE(Succeed(lease, ResultOf("g", "r")).ok()) << "computed anew, it may end";
}

}  // namespace
}  // namespace slicefarm::coordinator::job_store_contract_test
