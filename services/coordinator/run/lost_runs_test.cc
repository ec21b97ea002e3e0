#include "services/coordinator/run/lost_runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "common/base/error.h"

namespace slicefarm::coordinator::lost_runs_test {
namespace {

using enum JobState;

constexpr int64_t kSecondUs = 1'000'000;

JobRecord JobOf(JobState state, int32_t lost_runs, int64_t number = 0) {
  JobRecord job;
  job.state = state;
  job.lost_runs = lost_runs;
  job.number = number;
  return job;
}

struct Case {
  std::string name;
  JobState state;
  int32_t lost_runs;
  int64_t calm_s;
  int64_t rest_s;
  bool condemned = false;
};

class LostRunsTest : public testing::TestWithParam<Case> {};

TEST_P(LostRunsTest, SayWhenTheNextOneBegins) {
  const Case& c = GetParam();
  const LostRuns runs(JobOf(c.state, c.lost_runs), c.calm_s * kSecondUs);
  EXPECT_EQ(runs.condemned(), c.condemned);
  if (!c.condemned) {
    EXPECT_EQ(runs.rest_us(), c.rest_s * kSecondUs);
  }
  const bool begins = !c.condemned && c.rest_s == 0;
  EXPECT_EQ(DetailOf(runs.MayBegin()).reason == Reason::kJobPoisoned, !begins);
  EXPECT_EQ(runs.MayBegin().ok(), begins);
}

INSTANTIATE_TEST_SUITE_P(
    Runs, LostRunsTest,
    testing::Values(Case{"None", kQueued, 0, 0, 0}, Case{"TwoMeanNothing", kRunning, 2, 0, 0},
                    Case{"TheThirdMakesASuspect", kRunning, 3, 0, 4},
                    Case{"HoweverCalmItIsElsewhere", kRunning, 3, 1000, 4},
                    Case{"TwiceAsLongEachTime", kRunning, 4, 0, 8},
                    Case{"TheLastRestOfAll", kRunning, 9, 0, 256},
                    Case{"ARestedOneBegins", kQueued, 4, 8, 0},
                    Case{"NotOnAYoungCoordinator", kQueued, 4, 5, 3},
                    Case{"NorIfItsClockWasSetBack", kQueued, 4, -1, 8},
                    Case{"TheTenthCondemns", kRunning, 10, 1000, 0, true},
                    Case{"WhateverWasWrittenSince", kQueued, 11, 1000, 0, true}),
    [](const auto& info) { return info.param.name; });

TEST(LostRuns, JobsThatWereLostBesideEachOtherRestForDifferentTimes) {
  const auto rest_us = [](int32_t lost_runs, int64_t number) {
    return LostRuns(JobOf(kRunning, lost_runs, number), 0).rest_us();
  };
  EXPECT_EQ(rest_us(4, 7), 8 * kSecondUs * 15 / 8);
  for (int64_t other = 1; other < 64; ++other)
    EXPECT_TRUE(rest_us(8, 0) != rest_us(8, other) || rest_us(9, 0) != rest_us(9, other)) << other;
}

TEST(LostRuns, ServicesMayDieOfTwoRuns) {
  JobRecord job = JobOf(kQueued, 0);
  EXPECT_EQ(LostRuns(job, 0).RestAfterDeadlyRunUs(), 8 * kSecondUs);
  job.deadly_runs = 1;
  EXPECT_EQ(LostRuns(job, 3 * kSecondUs).rest_us(), 5 * kSecondUs);
  EXPECT_TRUE(LostRuns(job, 8 * kSecondUs).MayBegin().ok());
  EXPECT_EQ(LostRuns(job, 0).RestAfterDeadlyRunUs(), 64 * kSecondUs);
  job.deadly_runs = 2;
  EXPECT_EQ(LostRuns(job, 0).rest_us(), 64 * kSecondUs);
  EXPECT_FALSE(LostRuns(job, 0).condemned()) << "it has one more";
  EXPECT_EQ(LostRuns(job, 0).RestAfterDeadlyRunUs(), std::nullopt);
  job.lost_runs = 9;
  EXPECT_EQ(LostRuns(job, 0).rest_us(), 256 * kSecondUs) << "the longer of both";
}

TEST(LostRuns, ARunThatBeginsMayBeLost) {
  const LostRuns runs(JobOf(kQueued, 4), 1000 * kSecondUs);
  EXPECT_EQ(runs.After(kRunning), 5);
  EXPECT_EQ(runs.After(kQueued), 4);
  EXPECT_EQ(LostRuns().After(kRunning), 1);
}

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Simulated coordinator that is killed from outside now and then, until the kills stop. It
/// restarts at once.
class Coordinator {
 public:
  Coordinator(uint64_t seed, double mean_life_s, double storm_s)
      : random_(seed), mean_life_s_(mean_life_s), storm_s_(storm_s) {
    Die();
  }

  double now_s() const { return now_s_; }
  int64_t calm_us() const { return static_cast<int64_t>((now_s_ - begin_s_) * kSecondUs); }
  void Die() {
    begin_s_ = now_s_;
    const double part = (static_cast<double>(random_() >> 11) + 0.5) * 0x1p-53;
    end_s_ = now_s_ - mean_life_s_ * std::log(part);
    if (end_s_ > storm_s_) end_s_ = kNever;
  }
  /// Returns true if the coordinator lived for `time_s`.
  bool Live(double time_s) {
    const bool lives = now_s_ + time_s < end_s_;
    now_s_ = lives ? now_s_ + time_s : end_s_;
    if (!lives) Die();
    return lives;
  }

 private:
  std::mt19937_64 random_;
  const double mean_life_s_, storm_s_;
  double now_s_ = 0, begin_s_ = 0, end_s_ = 0;
};

struct Fate {
  bool condemned = false;
  int runs = 0;
  double end_s = 0;
};

/// Returns the fate of a job with this number. `kills`: each run kills its coordinator. Otherwise a
/// run takes `run_s`.
Fate FateOf(int64_t number, Coordinator coordinator, bool kills, double run_s) {
  JobRecord job = JobOf(kQueued, 0, number);
  for (Fate fate;; fate.end_s = coordinator.now_s()) {
    const LostRuns lost(job, coordinator.calm_us());
    fate.condemned = lost.condemned();
    if (fate.condemned) return fate;
    if (!lost.MayBegin().ok()) {
      job.state = kQueued;
      for (const double until_s = coordinator.now_s() + lost.rest_us() * 1e-6 + 1e-3;
           coordinator.now_s() < until_s;)
        coordinator.Live(until_s - coordinator.now_s());
      continue;
    }
    ++fate.runs;
    job.state = kRunning;
    job.lost_runs = lost.After(kRunning);
    const bool lived = coordinator.Live(run_s);
    if (lived && !kills) return fate;
    if (lived) coordinator.Die();
  }
}

TEST(LostRuns, NoJobIsCondemnedForWhatKillsCoordinatorsFromOutside) {
  for (const double run_s : {4.5, 10.0, 20.0}) {
    for (int64_t job = 0; job < 2'000; ++job) {
      const Coordinator stormy(job, /*mean_life_s=*/12, /*storm_s=*/3600);
      const Fate fate = FateOf(job, stormy, /*kills=*/false, run_s);
      EXPECT_FALSE(fate.condemned) << "job " << job << " of " << run_s << " s";
      EXPECT_LE(fate.end_s, 3600 + 600);
    }
  }
}

TEST(LostRuns, AJobThatKillsItsCoordinatorsIsFoundOut) {
  for (int64_t job = 0; job < 64; ++job) {
    const Fate calm = FateOf(job, Coordinator(job, kNever, 0), /*kills=*/true, 2);
    EXPECT_TRUE(calm.condemned);
    EXPECT_EQ(calm.runs, kMaxLostRuns);
    EXPECT_LE(calm.end_s, 1000);
    const Coordinator stormy(job, /*mean_life_s=*/12, /*storm_s=*/3600);
    const Fate in_storm = FateOf(job, stormy, /*kills=*/true, 2);
    EXPECT_TRUE(in_storm.condemned);
    EXPECT_EQ(in_storm.runs, kMaxLostRuns);
    EXPECT_LE(in_storm.end_s, 3600 + 1000);
  }
}

}  // namespace
}  // namespace slicefarm::coordinator::lost_runs_test
