#include "services/coordinator/algo/dispatch/range_scheduler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>

namespace slicefarm::coordinator::range_scheduler_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr RunnerId kA = 1, kB = 2, kC = 3;

TEST(RangeScheduler, GrantsInOrderAndEnds) {
  RangeScheduler scheduler(3);
  const auto first = scheduler.Next(kA, 0);
  const auto second = scheduler.Next(kB, 0);
  const auto third = scheduler.Next(kA, 0);
  ASSERT_TRUE(first && second && third);
  EXPECT_THAT((std::vector{first->range, second->range, third->range}), ElementsAre(0, 1, 2));
  EXPECT_FALSE(scheduler.Next(kA, 0));
  EXPECT_TRUE(scheduler.Succeeded(second->ticket, 1).first);
  EXPECT_TRUE(scheduler.Succeeded(first->ticket, 1).first);
  EXPECT_FALSE(scheduler.AllDone());
  EXPECT_TRUE(scheduler.Succeeded(third->ticket, 1).first);
  EXPECT_TRUE(scheduler.AllDone());
}

TEST(RangeScheduler, OfNothingIsDone) { EXPECT_TRUE(RangeScheduler(0).AllDone()); }

TEST(RangeScheduler, FailedRangeGoesToTheFront) {
  RangeScheduler scheduler(4);
  const auto lost = scheduler.Next(kA, 0);
  scheduler.Next(kB, 0);
  scheduler.Failed(lost->ticket);
  EXPECT_EQ(scheduler.Next(kB, 0)->range, 0);
  EXPECT_EQ(scheduler.Next(kB, 0)->range, 2);
  EXPECT_EQ(scheduler.Requeued(), 1);
}

TEST(RangeScheduler, FailedRangeGoesRatherToAnotherRunner) {
  RangeScheduler scheduler(2);
  scheduler.Failed(scheduler.Next(kA, 0)->ticket);
  EXPECT_EQ(scheduler.Next(kA, 0)->range, 1);
  EXPECT_EQ(scheduler.Next(kA, 0)->range, 0) << "when there is nothing else it tries again";
}

TEST(RangeScheduler, PoisonTakesThreeTriesOnTwoRunners) {
  RangeScheduler scheduler(1);
  scheduler.Failed(scheduler.Next(kA, 0)->ticket);
  scheduler.Failed(scheduler.Next(kB, 0)->ticket);
  EXPECT_FALSE(scheduler.Poisoned());
  scheduler.Failed(scheduler.Next(kA, 0)->ticket);
  EXPECT_EQ(scheduler.Poisoned(), 0);
  EXPECT_EQ(scheduler.Tries(0), 3);
  EXPECT_FALSE(scheduler.Next(kC, 0));
  EXPECT_FALSE(scheduler.Hedge(kC, 100));
}

TEST(RangeScheduler, OneRunnerAloneGetsMoreTries) {
  RangeScheduler scheduler(1);
  for (int i = 0; i < 9; ++i) scheduler.Failed(scheduler.Next(kA, 0)->ticket);
  EXPECT_FALSE(scheduler.Poisoned());
  scheduler.Failed(scheduler.Next(kA, 0)->ticket);
  EXPECT_EQ(scheduler.Poisoned(), 0);
}

TEST(RangeScheduler, WhatOneRunnerRefusesIsTriedThreeTimes) {
  RangeScheduler scheduler(1);
  scheduler.Failed(scheduler.Next(kA, 0)->ticket);
  for (int i = 0; i < 2; ++i) scheduler.Refused(scheduler.Next(kA, 0)->ticket);
  EXPECT_FALSE(scheduler.Poisoned()) << "it was refused twice";
  scheduler.Refused(scheduler.Next(kA, 0)->ticket);
  EXPECT_EQ(scheduler.Poisoned(), 0);
  EXPECT_EQ(scheduler.Tries(0), 4);
}

TEST(RangeScheduler, WhatARunnerDiedOfWaitsBesideTheQueue) {
  RangeScheduler scheduler(3);
  const auto first = scheduler.Next(kA, 0);
  scheduler.Died(first->ticket);
  EXPECT_EQ(scheduler.Suspects(), 1);
  EXPECT_EQ(scheduler.Next(kB, 0)->range, 1);
  EXPECT_EQ(scheduler.Next(kA, 0)->range, 2);
  EXPECT_FALSE(scheduler.Next(kB, 0));
  EXPECT_FALSE(scheduler.NextSuspect(kB, 1)) << "it waits for the one that died of it";
  const auto again = scheduler.NextSuspect(kA, 2);
  ASSERT_TRUE(again);
  EXPECT_TRUE(again->suspect);
  EXPECT_EQ(again->range, 0);
  EXPECT_FALSE(scheduler.Hedge(kB, 1e6)->range == 0) << "no second copy of a suspect";
  EXPECT_TRUE(scheduler.Succeeded(again->ticket, 3).first);
}

TEST(RangeScheduler, ASuspectGoesElsewhereWhenItsRunnerStaysAway) {
  RangeScheduler scheduler(1, {.elsewhere_after_s = 2});
  scheduler.Died(scheduler.Next(kA, 0)->ticket);
  EXPECT_FALSE(scheduler.MayTakeSuspect(kB, 10));
  EXPECT_FALSE(scheduler.NextSuspect(kB, 11.9));
  EXPECT_TRUE(scheduler.NextSuspect(kB, 12));
}

TEST(RangeScheduler, ASuspectIsTriedOnceOnEachRunner) {
  RangeScheduler scheduler(1);
  scheduler.Died(scheduler.Next(kA, 0)->ticket);
  scheduler.Died(scheduler.NextSuspect(kA, 0)->ticket);
  scheduler.Seen(kA);
  EXPECT_FALSE(scheduler.NextSuspect(kA, 1)) << "a connection may be broken for good";
  scheduler.Died(scheduler.NextSuspect(kB, 1)->ticket);
  EXPECT_EQ(scheduler.Poisoned(), 0) << "three tries on two runners";
  EXPECT_FALSE(scheduler.NextSuspect(kC, 100));
}

TEST(RangeScheduler, ASuspectGoesElsewhereWhenWhatDiedOfItIsBack) {
  RangeScheduler scheduler(1, {.elsewhere_after_s = 2});
  scheduler.Died(scheduler.Next(kA, 0)->ticket);
  scheduler.Died(scheduler.NextSuspect(kA, 0)->ticket);
  EXPECT_FALSE(scheduler.MayTakeSuspect(kB, 1)) << "both would be down";
  EXPECT_FALSE(scheduler.MayTakeSuspect(kA, 1.5)) << "it had its turn";
  EXPECT_FALSE(scheduler.MayTakeSuspect(kB, 1.5)) << "to ask is not to be back";
  scheduler.Seen(kA);
  EXPECT_TRUE(scheduler.NextSuspect(kB, 1.5));
}

TEST(RangeScheduler, HedgesTheOldestSlowRangeOnce) {
  RangeScheduler scheduler(2, {.hedge_after_s = 1});
  const auto old = scheduler.Next(kA, 0);
  scheduler.Next(kB, 2);
  EXPECT_FALSE(scheduler.Hedge(kC, 0.5)) << "not slow yet";
  EXPECT_FALSE(scheduler.Hedge(kA, 2.5)) << "it runs there";
  const auto copy = scheduler.Hedge(kC, 2.5);
  ASSERT_TRUE(copy);
  EXPECT_EQ(copy->range, 0);
  EXPECT_FALSE(scheduler.Hedge(kC, 2.6)) << "two copies are enough, and range 1 is young";

  const auto accepted = scheduler.Succeeded(copy->ticket, 3);
  EXPECT_TRUE(accepted.first);
  EXPECT_THAT(accepted.superfluous, ElementsAre(old->ticket));
  EXPECT_FALSE(scheduler.Succeeded(old->ticket, 3).first) << "the first answer won";
}

TEST(RangeScheduler, WhatIsSlowDependsOnTheOthers) {
  RangeScheduler scheduler(2, {.hedge_after_s = 1, .hedge_after_ratio = 2});
  scheduler.Succeeded(scheduler.Next(kA, 0)->ticket, 5);
  scheduler.Next(kA, 5);
  EXPECT_FALSE(scheduler.Hedge(kB, 14));
  EXPECT_TRUE(scheduler.Hedge(kB, 16));
}

TEST(RangeScheduler, ACopyThatFailsLeavesTheOther) {
  RangeScheduler scheduler(1, {.poison_tries = 1, .poison_runners = 1});
  const auto first = scheduler.Next(kA, 0);
  const auto second = scheduler.Hedge(kB, 10);
  scheduler.Failed(first->ticket);
  EXPECT_EQ(scheduler.Queued(), 0);
  EXPECT_FALSE(scheduler.Poisoned()) << "the other may still make it";
  EXPECT_TRUE(scheduler.Succeeded(second->ticket, 11).first);
}

TEST(RangeScheduler, ASlowRangeThatAlwaysFailsEndsTheJob) {
  RangeScheduler scheduler(1);
  std::optional<RangeScheduler::Grant> copy = scheduler.Next(kA, 0);
  // Whenever one copy fails, a second copy of the range is already running, because the range is
  // slow.
  for (int step = 1; step <= 20 && !scheduler.Poisoned(); ++step) {
    const auto second = scheduler.Hedge(step % 2 == 0 ? kA : kB, 10.0 * step);
    scheduler.Failed(copy->ticket);
    copy = second ? second : scheduler.Next(kA, 10.0 * step);
  }
  EXPECT_EQ(scheduler.Poisoned(), 0);
  EXPECT_EQ(scheduler.Tries(0), 4) << "the third failed beside a copy that might have made it";
}

TEST(RangeScheduler, RunnerGoneGivesItsRangesBackInOrder) {
  RangeScheduler scheduler(3);
  const auto a = scheduler.Next(kA, 0);
  scheduler.Next(kA, 0);
  scheduler.RunnerGone(kA);
  EXPECT_EQ(scheduler.Tries(0), 0) << "nothing is said of the range";
  EXPECT_EQ(scheduler.Next(kB, 0)->range, 0);
  EXPECT_EQ(scheduler.Next(kB, 0)->range, 1);

  const auto late = scheduler.Succeeded(a->ticket, 1);
  EXPECT_TRUE(late.first) << "a late result is a result";
  EXPECT_EQ(late.superfluous.size(), 1u);
}

TEST(RangeScheduler, LateResultTakesTheRangeOffTheQueue) {
  RangeScheduler scheduler(1);
  const auto a = scheduler.Next(kA, 0);
  scheduler.RunnerGone(kA);
  EXPECT_EQ(scheduler.Queued(), 1);
  EXPECT_TRUE(scheduler.Succeeded(a->ticket, 1).first);
  EXPECT_EQ(scheduler.Queued(), 0);
  EXPECT_TRUE(scheduler.AllDone());
}

TEST(RangeScheduler, UnknownTicketsChangeNothing) {
  RangeScheduler scheduler(1);
  scheduler.Failed(17);
  EXPECT_FALSE(scheduler.Succeeded(17, 0).first);
  EXPECT_EQ(scheduler.Queued(), 1);
}

/// Simulates random runners that answer, fail, disappear and answer late. Checks the invariants
/// after each step against a model of the state of all ranges.
class Simulation {
 public:
  explicit Simulation(uint32_t seed) : random_(seed), ranges_(1 + Pick(30)), scheduler_(ranges_) {}

  void Run() {
    for (int step = 0; step < 5000 && !scheduler_.AllDone() && !scheduler_.Poisoned(); ++step) {
      now_s_ += Pick(100) / 100.0;
      Step();
      Check();
    }
    if (scheduler_.Poisoned()) {
      EXPECT_GE(scheduler_.Tries(*scheduler_.Poisoned()), 3);
      EXPECT_TRUE(failed_on_[*scheduler_.Poisoned()].size() >= 2 ||
                  scheduler_.Tries(*scheduler_.Poisoned()) >= 10);
    } else {
      EXPECT_TRUE(scheduler_.AllDone()) << "it comes to an end";
      EXPECT_EQ(static_cast<int>(results_.size()), ranges_);
    }
  }

 private:
  struct Call {
    int32_t range;
    RunnerId runner;
    bool known;  ///< false once the scheduler knows that the runner has left
  };

  int Pick(int n) { return static_cast<int>(random_() % n); }

  void Step() {
    const int what = Pick(10);
    if (what < 5 || calls_.empty()) return GrantTo(1 + Pick(5));
    const auto call = std::next(calls_.begin(), Pick(static_cast<int>(calls_.size())));
    if (what < 8) return Succeed(call->first);
    if (what < 9) return Fail(call->first);
    Vanish(call->second.runner);
  }

  void GrantTo(RunnerId runner) {
    auto grant = scheduler_.Next(runner, now_s_);
    if (!grant) grant = scheduler_.Hedge(runner, now_s_);
    if (!grant) return;
    EXPECT_FALSE(results_.contains(grant->range)) << "done ranges are not granted";
    EXPECT_TRUE(calls_.emplace(grant->ticket, Call{grant->range, runner, true}).second);
  }

  void Succeed(int64_t ticket) {
    const int32_t range = calls_.at(ticket).range;
    const auto accepted = scheduler_.Succeeded(ticket, now_s_);
    calls_.erase(ticket);
    EXPECT_EQ(accepted.first, results_.insert(range).second) << "each range has one result";
    for (const int64_t other : accepted.superfluous) EXPECT_EQ(calls_.at(other).range, range);
  }

  void Fail(int64_t ticket) {
    const Call call = calls_.at(ticket);
    calls_.erase(ticket);
    if (call.known && !results_.contains(call.range)) failed_on_[call.range].insert(call.runner);
    scheduler_.Failed(ticket);
  }

  void Vanish(RunnerId runner) {
    scheduler_.RunnerGone(runner);
    for (auto& [ticket, call] : calls_) call.known &= call.runner != runner;
  }

  void Check() {
    std::map<int32_t, std::set<RunnerId>> running;
    int known = 0;
    for (const auto& [ticket, call] : calls_) {
      if (!call.known) continue;
      ++known;
      if (results_.contains(call.range)) continue;
      EXPECT_TRUE(running[call.range].insert(call.runner).second) << "copies on two runners";
    }
    EXPECT_EQ(scheduler_.Running(), known);
    for (const auto& [range, runners] : running) EXPECT_LE(runners.size(), 2u);
    EXPECT_EQ(scheduler_.Queued() + static_cast<int>(running.size() + results_.size()), ranges_)
        << "a range is queued, running or done";
  }

  std::mt19937 random_;
  int32_t ranges_;
  RangeScheduler scheduler_;
  double now_s_ = 0;
  std::map<int64_t, Call> calls_;
  std::set<int32_t> results_;
  std::map<int32_t, std::set<RunnerId>> failed_on_;
};

TEST(RangeScheduler, InvariantsHoldInSimulation) {
  for (uint32_t seed = 1; seed <= 3000; ++seed) {
    Simulation(seed).Run();
    ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace slicefarm::coordinator::range_scheduler_test
