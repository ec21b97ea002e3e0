// Tests that the simulation finds bugs: flaws of all its parts, within a limited number of seeds.
// CTest runs `slicefarm-sim --seeds` to show that there are no bugs without flaws.
#include "tests/sim/simulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/temp_directory_test.h"
#include "services/coordinator/store/jobs/sql_job_store.h"
#include "tests/sim/flawed_store_test.h"
#include "tests/sim/twin_store.h"
#include "tests/support/memory_job_store.h"

namespace slicefarm::coordinator::sim::simulation_test {
namespace {

using testing::HasSubstr;

/// Number of seeds that must find a flaw; CI runs the same number.
constexpr int kSeeds = 10'000;

Variant OfStore(FlawedStore::Flaw flaw) {
  return {.store = [flaw](World&, JobStore& store) {
    return std::make_unique<FlawedStore>(store, flaw);
  }};
}

Variant OfScheduler(const SchedulerOptions& options) { return {.scheduler = options}; }

struct Case {
  std::string name;
  Variant variant;
  std::string violation;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class FlawTest : public testing::TestWithParam<Case> {};

TEST_P(FlawTest, IsFound) {
  const Case& c = GetParam();
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const Outcome outcome = Simulate(static_cast<uint64_t>(seed), c.variant);
    if (!outcome.violation) continue;
    EXPECT_THAT(*outcome.violation, HasSubstr(c.violation));
    RecordProperty("seed", seed);
    return;
  }
  FAIL() << "not within " << kSeeds << " seeds";
}

using Flaw = FlawedStore::Flaw;

INSTANTIATE_TEST_SUITE_P(
    Flaws, FlawTest,
    testing::Values(
        Case{"NoFencing", OfStore(Flaw::kNoFencing), "by who held it in epoch"},
        Case{"StaleResultAccepted", OfStore(Flaw::kStaleResultAccepted), "by who held it in epoch"},
        Case{"RenewIgnored", OfStore(Flaw::kRenewIgnored), "was said to be held"},
        Case{"RequestIdIgnored", OfStore(Flaw::kRequestIdIgnored), "request r"},
        Case{"CreateNotWritten", OfStore(Flaw::kCreateNotWritten), "is lost"},
        Case{"HandBackNotWritten", OfStore(Flaw::kHandBackNotWritten), "a write of QUEUED"},
        Case{"EndNotWritten", OfStore(Flaw::kEndNotWritten), "a write of SUCCEEDED"},
        Case{"CancelNotWritten", OfStore(Flaw::kCancelNotWritten), "a request to cancel"},
        Case{"AdoptionNotWritten", OfStore(Flaw::kAdoptionNotWritten), "a wrong result"},
        Case{"HeldJobsClaimed", OfStore(Flaw::kHeldJobsClaimed), "claimed"},
        Case{"SameWorkClaimed", OfStore(Flaw::kSameWorkClaimed), "has the same done"},
        Case{"LostClaimRenewed", OfStore(Flaw::kLostClaimRenewed), "was said to be held"},
        Case{"RequestIdOfAll", OfStore(Flaw::kRequestIdOfAll), "request"},
        Case{"QueueUnbounded", OfStore(Flaw::kQueueUnbounded), "exceeds the queue"},
        Case{"CancelForgotten", OfStore(Flaw::kCancelForgotten), "does not hear"},
        Case{"PriorityIgnored", OfStore(Flaw::kPriorityIgnored), "is not the job"},
        Case{"TenantsIgnored", OfStore(Flaw::kTenantsIgnored), "it is the turn of"},
        Case{"SomeNeverClaimed", OfStore(Flaw::kSomeNeverClaimed), "it is the turn of"},
        Case{"ReferencesForgotten", OfStore(Flaw::kReferencesForgotten), "lacks its blob"},
        Case{"EventsSkipped", OfStore(Flaw::kEventsSkipped), "got event"},
        Case{"PoisonTooEarly", OfScheduler({.poison_tries = 2}), "ends its job after 2"},
        Case{"PoisonTooLate", OfScheduler({.poison_tries = 4}), "goes on after 3"},
        Case{"AnswersMixed", {.answers_mixed = true}, "a wrong result"},
        Case{"EveryAnswerCounts", {.every_answer_counts = true}, "layers are done"},
        Case{"FailuresUntold", {.failures_unreported = true}, "does not end"},
        Case{"ProcessesUntold", {.processes_unreported = true}, "that it does not run"},
        Case{"CancelsUnread", {.cancels_unread = true}, "after it was to be cancelled"},
        Case{"CalmUnasked", {.calm_unasked = true}, "failed with 'JOB_POISONED'"},
        Case{"LostRunsForgotten", OfStore(Flaw::kLostRunsForgotten), "does not end"},
        Case{"DeadlinesUnread", {.deadlines_unread = true}, "after its deadline"},
        Case{"BlobsNotKept", {.keep_blobs_s = 0}, "lacks its blob"}),
    [](const auto& info) { return info.param.name; });

std::string TraceOf(uint64_t seed) {
  std::string trace;
  const Outcome outcome =
      Simulate(seed, {}, [&](const std::string& line) { trace += line + "\n"; });
  EXPECT_EQ(outcome.violation, std::nullopt);
  return trace;
}

TEST(Simulation, ASeedIsReplayedToTheLastStep) {
  for (uint64_t seed = 1; seed <= 20; ++seed) EXPECT_EQ(TraceOf(seed), TraceOf(seed));
  EXPECT_NE(TraceOf(1), TraceOf(2));
}

TEST(Simulation, WhatATraceLeavesOutHappensWithoutAsWell) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const Outcome traced = Simulate(seed, {}, [](const std::string&) {});
    EXPECT_EQ(traced.totals.steps, Simulate(seed).totals.steps);
  }
}

TEST(Simulation, AStoreThatAnswersOtherwiseIsFound) {
  std::optional<std::string> violation;
  for (uint64_t seed = 1; seed <= kSeeds && !violation; ++seed) {
    MemoryJobs jobs;
    MemoryJobStore memory(jobs);
    const Variant beside{.store = [&](World& world, JobStore& store) {
      auto flawed = std::make_unique<FlawedStore>(memory, FlawedStore::Flaw::kPriorityIgnored);
      return std::make_unique<TwinStore>(world, store, std::move(flawed));
    }};
    violation = Simulate(seed, beside).violation;
  }
  EXPECT_THAT(violation.value_or(""), HasSubstr("the stores answer differently"));
}

TEST(Simulation, SqliteAnswersAsTheStoreInMemoryDoes) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const TempDirectory directory;
    const Variant beside{.store = [&](World& world, JobStore& store) {
      return std::make_unique<TwinStore>(world, store,
                                         *OpenSqliteJobStore(directory.path() + "/jobs.db"));
    }};
    EXPECT_EQ(Simulate(seed, beside).violation, std::nullopt) << seed;
  }
}

TEST(Simulation, EverythingThatMayHappenHappens) {
  Totals totals;
  for (uint64_t seed = 1; seed <= 500; ++seed) {
    const Outcome outcome = Simulate(seed);
    for (const TotalsField& field : kTotals) totals.*field.value += outcome.totals.*field.value;
  }
  for (const TotalsField& field : kTotals) EXPECT_GT(totals.*field.value, 5) << field.name;
}

}  // namespace
}  // namespace slicefarm::coordinator::sim::simulation_test
