#include "services/coordinator/algo/dispatch/fan_out.h"

#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::coordinator::fan_out_test {
namespace {

using std::chrono::milliseconds;
using Verdict = FanOut::Verdict;

TEST(FanOut, JobsTakeTurns) {
  FanOut fan_out;
  const auto first = fan_out.Add(3, Process::kFdm);
  const auto second = fan_out.Add(3, Process::kFdm);
  std::vector<FanOut::JobId> order;
  for (int i = 0; i < 6; ++i) order.push_back(fan_out.Take(1, 0)->job);
  EXPECT_EQ(order, (std::vector<FanOut::JobId>{first, second, first, second, first, second}));
  EXPECT_FALSE(fan_out.AnyQueued());
  EXPECT_EQ(fan_out.Take(1, 0), std::nullopt);
}

TEST(FanOut, TheJobWithTheFewestRangesInFlightComesFirst) {
  FanOut fan_out;
  const auto first = fan_out.Add(9, Process::kFdm);
  for (int i = 0; i < 3; ++i) fan_out.Take(1, 0);
  const auto late = fan_out.Add(9, Process::kFdm);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(fan_out.Take(1, 0)->job, late);
  EXPECT_EQ(fan_out.Take(1, 0)->job, first);
}

TEST(FanOut, TenantsShareEvenlyHoweverManyJobsTheyHave) {
  FanOut fan_out;
  for (int i = 0; i < 7; ++i) fan_out.Add(9, Process::kFdm, {"many"});
  for (int i = 0; i < 4; ++i) fan_out.Take(1, 0);
  const auto one = fan_out.Add(9, Process::kFdm, {"one"});
  int of_one = 0;
  for (int i = 0; i < 12; ++i) of_one += fan_out.Take(1, 0)->job == one;
  EXPECT_EQ(of_one, 8) << "as many as the other tenant then has";
}

TEST(FanOut, ATenantsUrgentJobComesBeforeItsOthers) {
  FanOut fan_out;
  const auto bulk = fan_out.Add(9, Process::kFdm, {"a", 0});
  fan_out.Take(1, 0);
  const auto urgent = fan_out.Add(3, Process::kFdm, {"a", 2});
  const auto others = fan_out.Add(9, Process::kFdm, {"b", 0});
  std::vector<FanOut::JobId> order;
  for (int i = 0; i < 8; ++i) order.push_back(fan_out.Take(1, 0)->job);
  EXPECT_EQ(order, (std::vector<FanOut::JobId>{others, urgent, others, urgent, others, urgent,
                                               others, bulk}));
}

TEST(FanOut, NothingIsDoubledWhileAnythingIsQueued) {
  FanOut fan_out;
  const auto slow = fan_out.Add(1, Process::kFdm);
  fan_out.Take(1, 0);
  const auto other = fan_out.Add(1, Process::kFdm);
  EXPECT_EQ(fan_out.Take(2, 100)->job, other);
  EXPECT_EQ(fan_out.Take(2, 100)->job, slow) << "a second copy of what runner 1 does not end";
  EXPECT_EQ(fan_out.Counts().hedged, 1);
}

TEST(FanOut, SecondCopiesHaveABudget) {
  FanOut fan_out({.hedge_after_s = 1, .hedge_share = 0.5, .hedge_burst = 1});
  fan_out.Add(4, Process::kFdm);
  const auto first = *fan_out.Take(1, 0);
  const auto second = *fan_out.Take(1, 0);
  const auto third = *fan_out.Take(1, 0);
  fan_out.Take(1, 0);
  EXPECT_TRUE(fan_out.Take(2, 100)) << "of the first";
  EXPECT_FALSE(fan_out.Take(2, 100)) << "all four are slow, and the budget is spent";
  fan_out.Succeeded(second, 0.5);
  EXPECT_FALSE(fan_out.Take(2, 100));
  fan_out.Succeeded(third, 0.5);
  const auto copy = fan_out.Take(2, 100);
  ASSERT_TRUE(copy) << "two ranges are done: one more";
  EXPECT_EQ(copy->range, 3);
  EXPECT_NE(copy->range, first.range);
}

TEST(FanOut, ErrorsEndAJobOrDoNot) {
  FanOut fan_out;
  const auto job = fan_out.Add(1, Process::kFdm);
  const auto fail = [&](RunnerId runner, const absl::Status& error, double now_s = 0) {
    return fan_out.Failed(*fan_out.Take(runner, now_s), error);
  };
  const auto misfit = MakeError(absl::StatusCode::kFailedPrecondition, Reason::kBuildMismatch, "");
  EXPECT_EQ(fail(1, misfit), Verdict::kGoesOn);
  EXPECT_EQ(fan_out.Tries(job, 0), 0) << "says nothing of the range";
  EXPECT_EQ(fail(1, absl::UnavailableError("")), Verdict::kGoesOn);
  EXPECT_EQ(fail(1, absl::InternalError("")), Verdict::kGoesOn);
  EXPECT_EQ(fail(2, absl::UnavailableError("")), Verdict::kPoisoned) << "tried there alone";
  EXPECT_EQ(fan_out.Counts().poisoned, 1);
  const auto bad = fan_out.Add(1, Process::kFdm);
  const auto grant = *fan_out.Take(1, 0);
  EXPECT_EQ(grant.job, bad);
  EXPECT_EQ(fan_out.Failed(grant, absl::InvalidArgumentError("")), Verdict::kInputAtFault);
}

TEST(FanOut, OneRunnerMayBeBusyMoreOftenThanItMayRefuse) {
  const auto tries_of = [](const absl::Status& error) {
    FanOut fan_out;
    const auto job = fan_out.Add(1, Process::kFdm);
    while (fan_out.Failed(*fan_out.Take(1, 0), error) == Verdict::kGoesOn) continue;
    return fan_out.Tries(job, 0);
  };
  EXPECT_EQ(tries_of(absl::InternalError("no such layer")), 3);
  EXPECT_EQ(tries_of(absl::ResourceExhaustedError("no slot is free")), 10);
}

const absl::Status kBroken = absl::UnavailableError("Socket closed");

TEST(FanOut, WhatARunnerDiedOfRunsAlone) {
  FanOut fan_out;
  const auto poison = fan_out.Add(1, Process::kFdm, {"a"});
  const auto other = fan_out.Add(9, Process::kFdm, {"b"});
  const auto killer = *fan_out.Take(1, 0), innocent = *fan_out.Take(1, 0);
  EXPECT_EQ(fan_out.Take(2, 0)->job, other);
  EXPECT_EQ(killer.job, poison);
  EXPECT_EQ(innocent.job, other);
  EXPECT_EQ(fan_out.Failed(killer, kBroken), Verdict::kGoesOn);
  EXPECT_EQ(fan_out.Failed(innocent, kBroken), Verdict::kGoesOn);
  EXPECT_EQ(fan_out.Take(2, 1)->job, other) << "the other runner goes on with what is queued";
  const auto again = *fan_out.Take(1, 1);  // it is back
  EXPECT_TRUE(again.alone);
  EXPECT_EQ(again.job, poison);
  EXPECT_FALSE(fan_out.MayTake(1, 1));
  EXPECT_FALSE(fan_out.Take(1, 1)) << "nothing beside it";
  const auto next = *fan_out.Take(2, 9);
  EXPECT_FALSE(next.alone) << "one suspect at a time";
  fan_out.Failed(again, kBroken);
  const auto cleared = *fan_out.Take(1, 9);
  EXPECT_TRUE(cleared.alone);
  EXPECT_EQ(cleared.job, other) << "the innocent one";
  EXPECT_TRUE(fan_out.Succeeded(cleared, 10).first);
  EXPECT_FALSE(fan_out.Take(1, 10)->alone);
}

TEST(FanOut, ARunnerIsKeptFreeForASuspect) {
  FanOut fan_out;
  fan_out.Add(9, Process::kFdm);
  const auto killer = *fan_out.Take(1, 0);
  const auto busy = *fan_out.Take(2, 0), more = *fan_out.Take(2, 0);
  fan_out.Failed(killer, kBroken);
  fan_out.RunnerGone(1);
  fan_out.Succeeded(more, 1);
  EXPECT_TRUE(fan_out.MayTake(2, 1)) << "runner 1 may come back";
  fan_out.Succeeded(*fan_out.Take(2, 1), 2);
  EXPECT_FALSE(fan_out.MayTake(2, 3.5));
  EXPECT_FALSE(fan_out.Take(2, 3.5));
  EXPECT_TRUE(fan_out.MayTake(3, 3.5)) << "another one that is idle has it at once";
  fan_out.Succeeded(busy, 4);
  EXPECT_TRUE(fan_out.MayTake(2, 4));
  const auto suspect = *fan_out.Take(2, 4);
  EXPECT_TRUE(suspect.alone);
  EXPECT_EQ(suspect.range, killer.range);
}

TEST(FanOut, AServerThatSaysWhyDidNotDie) {
  FanOut fan_out;
  fan_out.Add(1, Process::kFdm);
  const auto stops = MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable, "it stops",
                               {{"retry_after_ms", "100"}});
  fan_out.Failed(*fan_out.Take(1, 0), stops);
  EXPECT_FALSE(fan_out.AnySuspects());
  EXPECT_FALSE(fan_out.Take(1, 0)->alone);
}

TEST(FanOut, ASuspectOfAJobThatIsGoneHoldsNothingUp) {
  FanOut fan_out;
  const auto job = fan_out.Add(1, Process::kFdm);
  fan_out.Failed(*fan_out.Take(1, 0), kBroken);
  const auto alone = *fan_out.Take(1, 0);
  fan_out.Remove(job);
  fan_out.Add(1, Process::kFdm);
  EXPECT_FALSE(fan_out.Take(1, 0));
  fan_out.Returned(alone);
  EXPECT_TRUE(fan_out.Take(1, 0));
}

TEST(FanOut, AnswersForAJobThatIsGoneMeanNothing) {
  FanOut fan_out;
  const auto job = fan_out.Add(2, Process::kFdm);
  const auto one = *fan_out.Take(1, 0);
  const auto two = *fan_out.Take(1, 0);
  fan_out.Remove(job);
  fan_out.Remove(job);
  EXPECT_FALSE(fan_out.Succeeded(one, 1).first);
  EXPECT_EQ(fan_out.Failed(two, absl::InvalidArgumentError("")), Verdict::kGoesOn);
  EXPECT_EQ(fan_out.Counts().done, 0);
}

TEST(FanOut, RequeuedRangesAreCountedAfterTheirJobAsWell) {
  FanOut fan_out;
  const auto job = fan_out.Add(2, Process::kFdm);
  fan_out.Take(1, 0);
  fan_out.RunnerGone(1);
  EXPECT_EQ(fan_out.Counts().requeued, 1);
  fan_out.Remove(job);
  EXPECT_EQ(fan_out.Counts().requeued, 1);
}

TEST(FanOut, RestsDoubleUpToTheMaximum) {
  const auto rest = [](int failures) {
    return RestAfter(failures, milliseconds(20), milliseconds(1000));
  };
  EXPECT_EQ(rest(1), milliseconds(20));
  EXPECT_EQ(rest(3), milliseconds(80));
  EXPECT_EQ(rest(60), milliseconds(1000));
}

TEST(FanOut, ARunnerGetsTasksOfItsProcessesOnly) {
  FanOut fan_out;
  const auto fdm = fan_out.Add(2, Process::kFdm);
  const auto laser = fan_out.Add(2, Process::kLaser);
  EXPECT_TRUE(fan_out.AnyQueued({Process::kLaser}));
  for (int i = 0; i < 2; ++i) {
    const auto grant = fan_out.Take(1, 0, {Process::kLaser});
    ASSERT_TRUE(grant.has_value());
    EXPECT_EQ(grant->job, laser);
  }
  EXPECT_FALSE(fan_out.AnyQueued({Process::kLaser}));
  EXPECT_TRUE(fan_out.AnyQueued({Process::kFdm}));
  EXPECT_FALSE(fan_out.Take(1, 0, {Process::kLaser}).has_value());
  EXPECT_FALSE(fan_out.Take(2, 0, {}).has_value());
  const auto grant = fan_out.Take(2, 0);
  ASSERT_TRUE(grant.has_value());
  EXPECT_EQ(grant->job, fdm);
}

// Only runners that support the process get second copies of slow ranges.
TEST(FanOut, DoublesGoToRunnersOfTheProcessOnly) {
  FanOut fan_out({.hedge_after_s = 0});
  const auto laser = fan_out.Add(2, Process::kLaser);
  const auto first = fan_out.Take(1, 0);
  ASSERT_TRUE(first.has_value());
  const auto second = fan_out.Take(2, 0);
  ASSERT_TRUE(second.has_value());
  fan_out.Succeeded(*second, 1);
  EXPECT_FALSE(fan_out.Take(3, 1e6, {Process::kFdm}).has_value());
  const auto twin = fan_out.Take(3, 1e6, {Process::kLaser});
  ASSERT_TRUE(twin.has_value());
  EXPECT_EQ(twin->job, laser);
  EXPECT_EQ(twin->range, first->range);
}

}  // namespace
}  // namespace slicefarm::coordinator::fan_out_test
