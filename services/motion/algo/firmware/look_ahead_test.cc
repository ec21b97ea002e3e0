#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "common/kinematics/klipper_junction.h"
#include "common/kinematics/marlin_junction.h"
#include "common/kinematics/planner.h"
#include "common/kinematics/reprap_junction.h"
#include "services/motion/algo/firmware/klipper.h"
#include "services/motion/algo/firmware/marlin.h"
#include "services/motion/algo/firmware/reprap.h"

namespace slicefarm::motion::look_ahead_test {
namespace {

constexpr double kPi = std::numbers::pi;

KinematicMove Towards(double angle_rad, double length_mm, double speed_mm_s = 100,
                      double acceleration_mm_s2 = 3000) {
  return {
      length_mm, {std::cos(angle_rad), std::sin(angle_rad), 0, 0}, speed_mm_s, acceleration_mm_s2};
}

MachineLimits Wide() {
  MachineLimits limits;
  limits.max_feedrate_mm_s = {1000, 1000, 1000, 1000};
  limits.max_acceleration_mm_s2 = {1e5, 1e5, 1e5, 1e5};
  return limits;
}

struct Rules {
  std::string name;
  const Firmware& (*firmware)();
  double junction_deviation_mm;
  double cruise_ratio;

  MachineLimits Limits() const {
    MachineLimits limits = Wide();
    limits.junction_deviation_mm = junction_deviation_mm;
    limits.minimum_cruise_ratio = cruise_ratio;
    return limits;
  }
};

std::vector<KinematicMove> RandomMoves(uint32_t seed, size_t count) {
  std::mt19937 random(seed);
  const auto in = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random() % 100'000) / 100'000;
  };
  std::vector<KinematicMove> moves;
  double angle = 0;
  for (size_t i = 0; i < count; ++i) {
    angle += random() % 5 == 0 ? in(-kPi, kPi) : in(-0.3, 0.3);
    moves.push_back(Towards(angle, in(0.02, 6), in(20, 150), in(500, 3000)));
    moves.back().ratio[kE] = random() % 4 == 0 ? 0 : 0.033;
  }
  return moves;
}

double JunctionV2(const Rules& rules, const KinematicMove& before, const KinematicMove& move,
                  const MachineLimits& limits) {
  if (rules.firmware == Klipper)
    return KlipperJunctionV2(LimitedByKlipper(before, limits), LimitedByKlipper(move, limits));
  if (rules.firmware == RepRap)
    return RepRapJunctionV2(LimitedByRepRap(before, limits), LimitedByRepRap(move, limits), limits);
  if (rules.junction_deviation_mm > 0) return JunctionDeviationV2(before, move, limits);
  return std::pow(ClassicJerkSpeed(before, move, limits), 2);
}

double Total(std::span<const MoveProfile> profiles) {
  double time = 0;
  for (const MoveProfile& profile : profiles) time += profile.time_s;
  return time;
}

TEST(Planner, NoMoves) {
  const auto planner = Marlin2().MakePlanner(Wide());
  EXPECT_TRUE(planner->Plan({}).empty());
}

TEST(Planner, KlipperLine) {
  const auto planner = Klipper().MakePlanner(Wide());
  const std::vector<KinematicMove> line = {Towards(0, 100)};
  EXPECT_NEAR(Total(planner->Plan(line)), 1.033333333333, 1e-12);
}

TEST(Planner, KlipperCorner) {
  const auto planner = Klipper().MakePlanner(Wide());
  const std::vector<KinematicMove> corner = {Towards(0, 100), Towards(kPi / 2, 100)};
  const auto profiles = planner->Plan(corner);
  EXPECT_NEAR(profiles[0].time_s, 1.031708333333, 1e-9);
  EXPECT_NEAR(profiles[1].time_s, 1.031708333333, 1e-9);
  EXPECT_NEAR(profiles[0].exit_mm_s, 5, 1e-9);
}

/// Move given by displacements and requested speed, with the time that Klipper's host code (August
/// 2026) plans for it.
/// The limits are max_accel 3000, square_corner_velocity 5, minimum_cruise_ratio 0.5, z 20 mm/s and
/// 500 mm/s^2, extruder 1500 mm/s^2.
struct Recorded {
  double x, y, z, e;
  double speed_mm_s;
  double time_s;
};

TEST(Planner, ReproducesKlippersHostCode) {
  const std::vector<Recorded> recorded = {
      {0, 0, 0, 0.8, 35, 0.046188022},        {20, 0, 0, 0.67698, 40, 0.507253197},
      {0.3, 0.1, 0, 0.01, 40, 0.008807851},   {0.3, 0.2, 0, 0.012, 60, 0.010659732},
      {0.2, 0.3, 0, 0.012, 60, 0.013458947},  {0, 5, 0, 0.16925, 60, 0.097311689},
      {-0.5, 0, 0, 0.01692, 80, 0.024206146}, {0, -5, 0, 0.16925, 80, 0.086604731},
      {-1.2, 0.9, 0, 0, 150, 0.045750004},    {3, 0.05, 0, 0.1, 80, 0.066350052},
      {0, 0, 0, -0.8, 35, 0.046188022},       {0, 0, 0.4, 0, 20, 0.052779924},
      {30, 40, 0, 0, 150, 0.381981765},       {0, 0, -0.4, 0, 20, 0.052779924},
      {0, 0, 0, 0.8, 35, 0.046188022},        {1, 0, 0, 0.06, 80, 0.038217026},
      {-1, 0.4, 0, 0.06, 80, 0.039167906},    {1, 0, 0, 0.06, 80, 0.038217026},
  };
  std::vector<KinematicMove> moves;
  for (const Recorded& r : recorded) {
    double length = std::sqrt(r.x * r.x + r.y * r.y + r.z * r.z);
    if (length == 0) length = std::abs(r.e);
    moves.push_back(
        {length, {r.x / length, r.y / length, r.z / length, r.e / length}, r.speed_mm_s, 3000});
  }
  const auto planner = Klipper().MakePlanner(MachineLimits{});
  const auto profiles = planner->Plan(moves);
  for (size_t i = 0; i < recorded.size(); ++i) {
    EXPECT_NEAR(profiles[i].time_s, recorded[i].time_s, 2e-9) << i;
  }
}

TEST(Planner, KlipperSavesShortZigzagsTheirPeaks) {
  // A move from rest to rest may be too short to cruise for half its length. Its peak speed is then
  // the one that half the acceleration would reach.
  MachineLimits limits = Wide();
  limits.minimum_cruise_ratio = 0.5;
  const auto planner = Klipper().MakePlanner(limits);
  const std::vector<KinematicMove> zigzag = {Towards(0, 1), Towards(kPi, 1), Towards(0, 1)};
  for (const MoveProfile& profile : planner->Plan(zigzag)) {
    EXPECT_NEAR(profile.cruise_mm_s, std::sqrt(0.5 * 3000 * 1), 1e-6);
  }
  limits.minimum_cruise_ratio = 0;
  const auto free = Klipper().MakePlanner(limits);
  EXPECT_NEAR(free->Plan(zigzag)[1].cruise_mm_s, std::sqrt(3000 * 1), 1e-6);
}

TEST(Planner, MarlinJerkStartsAtTheSafeSpeed) {
  MachineLimits limits = Wide();
  limits.max_jerk_mm_s = {8, 8, 0.4, 2.5};
  const auto planner = Marlin2().MakePlanner(limits);
  const std::vector<KinematicMove> line = {Towards(0, 100)};
  const auto profiles = planner->Plan(line);
  EXPECT_DOUBLE_EQ(profiles[0].entry_mm_s, 8);
  EXPECT_NEAR(profiles[0].exit_mm_s, kMarlinRestMmS, 1e-12);
}

TEST(Planner, LooksAhead) {
  // Ten short straight moves are equal to one long move.
  MachineLimits limits = Wide();
  limits.junction_deviation_mm = 0.02;
  for (const auto firmware : {Marlin2, Klipper, RepRap}) {
    const auto planner = firmware().MakePlanner(limits);
    const std::vector<KinematicMove> whole = {Towards(0, 10)};
    const std::vector<KinematicMove> parts(10, Towards(0, 1));
    const double time = Total(planner->Plan(whole));
    EXPECT_NEAR(Total(planner->Plan(parts)), time, 1e-6);
  }
}

TEST(Planner, ForgetsTheRunBefore) {
  const auto planner = Klipper().MakePlanner(Wide());
  const auto moves = RandomMoves(1, 50);
  const double time = Total(planner->Plan(moves));
  planner->Plan(RandomMoves(2, 200));
  EXPECT_EQ(Total(planner->Plan(moves)), time);
}

class RulesTest : public testing::TestWithParam<Rules> {};

TEST_P(RulesTest, SpeedsAreContinuousAndWithinLimits) {
  const Rules& rules = GetParam();
  const MachineLimits limits = rules.Limits();
  const auto planner = rules.firmware().MakePlanner(limits);
  for (uint32_t seed = 0; seed < 20; ++seed) {
    const auto moves = RandomMoves(seed, 200);
    const auto profiles = planner->Plan(moves);
    for (size_t i = 0; i < moves.size(); ++i) {
      const MoveProfile& p = profiles[i];
      const double reach = 2 * moves[i].length_mm * moves[i].acceleration_mm_s2 * (1 + 1e-9);
      ASSERT_LE(p.cruise_mm_s, moves[i].speed_mm_s + 1e-9);
      ASSERT_LE(p.cruise_mm_s * p.cruise_mm_s * 2 - p.entry_mm_s * p.entry_mm_s -
                    p.exit_mm_s * p.exit_mm_s,
                reach + 1e-6);
      ASSERT_GE(p.time_s, moves[i].length_mm / moves[i].speed_mm_s * (1 - 1e-9));
      if (i == 0) continue;
      ASSERT_NEAR(p.entry_mm_s, profiles[i - 1].exit_mm_s, 1e-6) << i;
      const double junction = std::sqrt(JunctionV2(rules, moves[i - 1], moves[i], limits));
      ASSERT_LE(p.entry_mm_s, junction + 1e-6);
    }
  }
}

/// Returns the shortest time along the moves under the junction limits, found on a fine grid: speed
/// limits from both sides, then the time of each small step.
double FineTime(const std::vector<KinematicMove>& moves, const std::vector<double>& junction_v2) {
  constexpr int kSteps = 2000;
  std::vector<double> v2 = {junction_v2[0]};
  std::vector<double> step_mm;
  std::vector<double> acceleration;
  for (size_t i = 0; i < moves.size(); ++i) {
    for (int k = 0; k < kSteps; ++k) {
      step_mm.push_back(moves[i].length_mm / kSteps);
      acceleration.push_back(moves[i].acceleration_mm_s2);
      const double top = moves[i].speed_mm_s * moves[i].speed_mm_s;
      v2.push_back(k + 1 < kSteps ? top : junction_v2[i + 1]);
    }
  }
  for (size_t k = 0; k < step_mm.size(); ++k) {
    v2[k + 1] = std::min(v2[k + 1], v2[k] + 2 * acceleration[k] * step_mm[k]);
  }
  double time = 0;
  for (size_t k = step_mm.size(); k-- > 0;) {
    v2[k] = std::min(v2[k], v2[k + 1] + 2 * acceleration[k] * step_mm[k]);
    time += 2 * step_mm[k] / (std::sqrt(v2[k]) + std::sqrt(v2[k + 1]));
  }
  return time;
}

/// Rules that do not lower peak speeds on purpose.
class FullSpeedTest : public testing::TestWithParam<Rules> {};

TEST_P(FullSpeedTest, AgreesWithAFineSimulation) {
  const Rules& rules = GetParam();
  const MachineLimits limits = rules.Limits();
  const auto planner = rules.firmware().MakePlanner(limits);
  for (uint32_t seed = 0; seed < 5; ++seed) {
    const auto moves = RandomMoves(seed + 100, 40);
    std::vector<double> junction_v2(moves.size() + 1, 0);
    for (size_t i = 1; i < moves.size(); ++i) {
      junction_v2[i] = JunctionV2(rules, moves[i - 1], moves[i], limits);
    }
    if (rules.firmware == Marlin2) {
      if (rules.junction_deviation_mm == 0) {
        junction_v2[0] = std::pow(SafeSpeed(moves[0], limits), 2);
      }
      junction_v2.back() = kMarlinRestMmS * kMarlinRestMmS;
    }
    const double want = FineTime(moves, junction_v2);
    EXPECT_NEAR(Total(planner->Plan(moves)), want, 2e-3 * want);
  }
}

TEST_P(RulesTest, FasterSettingsAreNeverSlower) {
  const Rules& rules = GetParam();
  const auto planner = rules.firmware().MakePlanner(rules.Limits());
  for (uint32_t seed = 0; seed < 10; ++seed) {
    auto moves = RandomMoves(seed, 100);
    const double time = Total(planner->Plan(moves));
    for (KinematicMove& move : moves) move.acceleration_mm_s2 *= 2;
    EXPECT_LE(Total(planner->Plan(moves)), time * (1 + 1e-9));
  }
}

/// Rules that do not depend on single axes.
class RoundTest : public testing::TestWithParam<Rules> {};

TEST_P(RoundTest, TurningThePathChangesNothing) {
  const Rules& rules = GetParam();
  const auto planner = rules.firmware().MakePlanner(rules.Limits());
  auto moves = RandomMoves(7, 100);
  const double time = Total(planner->Plan(moves));
  for (KinematicMove& move : moves) {
    std::swap(move.ratio[kX], move.ratio[kY]);
    move.ratio[kX] = -move.ratio[kX];
  }
  EXPECT_NEAR(Total(planner->Plan(moves)), time, 1e-6);
}

const Rules kMarlinJerk{"MarlinJerk", Marlin2, 0, 0};
const Rules kMarlinDeviation{"MarlinDeviation", Marlin2, 0.02, 0};
const Rules kMarlinLegacy{"MarlinLegacy", MarlinLegacy, 0, 0};
const Rules kRepRap{"RepRap", RepRap, 0, 0};
const Rules kKlipper{"Klipper", Klipper, 0, 0.5};
const Rules kKlipperFullSpeed{"KlipperFullSpeed", Klipper, 0, 0};

std::string NameOf(const testing::TestParamInfo<Rules>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Planner, RulesTest,
                         testing::Values(kMarlinJerk, kMarlinDeviation, kMarlinLegacy, kKlipper,
                                         kKlipperFullSpeed, kRepRap),
                         NameOf);
INSTANTIATE_TEST_SUITE_P(Planner, FullSpeedTest,
                         testing::Values(kMarlinJerk, kMarlinDeviation, kKlipperFullSpeed, kRepRap),
                         NameOf);
INSTANTIATE_TEST_SUITE_P(Planner, RoundTest,
                         testing::Values(kMarlinDeviation, kKlipper, kKlipperFullSpeed), NameOf);

}  // namespace
}  // namespace slicefarm::motion::look_ahead_test
