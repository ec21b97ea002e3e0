#include "common/kinematics/jerk_planner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace slicefarm::jerk_planner_test {
namespace {

MachineLimits Limits(double jerk = 1e5) {
  MachineLimits limits;
  limits.max_feedrate_mm_s = {1000, 1000, 1000, 1000};
  limits.max_acceleration_mm_s2 = {1e5, 1e5, 1e5, 1e5};
  limits.jerk_mm_s3 = jerk;
  return limits;
}

KinematicMove Towards(double angle_rad, double length_mm, double speed_mm_s = 100) {
  return {length_mm, {std::cos(angle_rad), std::sin(angle_rad), 0, 0}, speed_mm_s, 1000};
}

double Total(std::span<const MoveProfile> profiles) {
  double time_s = 0;
  for (const MoveProfile& profile : profiles) time_s += profile.time_s;
  return time_s;
}

double TimeOf(const std::vector<KinematicMove>& moves, double jerk = 1e5) {
  JerkPlanner planner(Limits(jerk));
  return Total(planner.Plan(moves));
}

// The closed formulas for a move from rest to rest.
TEST(JerkPlanner, SevenPhasesAndShortMoves) {
  for (const auto& [length, time_s] :
       {std::pair{40.0, 0.51}, {12.0, 0.23}, {11.0, 0.22}, {4.0, 0.1368858}, {0.05, 0.0251984}})
    EXPECT_NEAR(TimeOf({Towards(0, length)}), time_s, 1e-7) << length;
}

TEST(JerkPlanner, CutIntoPiecesTheWayTakesAsLong) {
  for (const double length : {40.0, 4.0, 0.05})
    EXPECT_NEAR(TimeOf(std::vector(16, Towards(1, length / 16))), TimeOf({Towards(1, length)}),
                1e-9);
}

TEST(JerkPlanner, WithoutALimitOfJerkItIsATrapezoid) {
  EXPECT_NEAR(TimeOf({Towards(0, 100)}, 1e9), 1 + 100.0 / 1000, 2e-6);
}

TEST(JerkPlanner, CirclesAreRunAtTheSpeedOfTheirCurvature) {
  const double radius = 2;  // sqrt(a R) = 44.72 mm/s; (j R^2)^(1/3) = 73.7 mm/s
  const int chords = 1000;
  std::vector<KinematicMove> moves;
  for (int i = 0; i < chords; ++i) {
    const double turn = 2 * std::numbers::pi / chords;
    moves.push_back(Towards(i * turn, 2 * radius * std::sin(turn / 2)));
  }
  JerkPlanner planner(Limits());
  const auto profiles = planner.Plan(moves);
  EXPECT_NEAR(profiles[chords / 2].cruise_mm_s, std::sqrt(1000 * radius), 1e-3);
  EXPECT_NEAR(profiles[chords / 2].time_s, moves[0].length_mm / std::sqrt(1000 * radius), 1e-7);
}

// A speed of 80 mm/s cannot be stopped within 1 mm, so earlier moves must slow down.
TEST(JerkPlanner, LooksAheadOverManyMoves) {
  std::vector<KinematicMove> moves(6, Towards(0, 1));
  for (size_t i = 0; i < moves.size(); ++i) moves[i].speed_mm_s = i % 2 == 0 ? 100 : 50;
  JerkPlanner planner(Limits());
  const auto profiles = planner.Plan(moves);
  for (size_t i = 0; i < profiles.size(); ++i) {
    const RampLimits limits{1000, 1e5};
    EXPECT_LE(RampLength(profiles[i].entry_mm_s, profiles[i].exit_mm_s, limits), 1 + 1e-9) << i;
    EXPECT_EQ(profiles[i].entry_mm_s, i > 0 ? profiles[i - 1].exit_mm_s : 0);
  }
  EXPECT_EQ(profiles.back().exit_mm_s, 0);
}

// A slower part ahead does not slow down the whole straight path before it.
TEST(JerkPlanner, FastLinesStayFastBeforeSlowOnes) {
  JerkPlanner planner(Limits());
  const KinematicMove moves[] = {Towards(0, 40), Towards(0, 40, 50)};
  const auto profiles = planner.Plan(moves);
  EXPECT_EQ(profiles[0].cruise_mm_s, 100);
  EXPECT_EQ(profiles[0].exit_mm_s, 50);
}

TEST(JerkPlanner, FilamentAloneIsAStop) {
  JerkPlanner planner(Limits());
  const KinematicMove moves[] = {Towards(0, 40), {0.8, {0, 0, 0, -1}, 35, 1000}, Towards(0, 40)};
  const auto profiles = planner.Plan(moves);
  EXPECT_EQ(profiles[0].exit_mm_s, 0);
  EXPECT_NEAR(profiles[2].time_s, 0.51, 1e-9);
}

// On random paths, speeds are within the limits, continuous, and never faster than with trapezoids.
TEST(JerkPlanner, RandomWaysKeepTheirLimits) {
  std::mt19937 random(3);
  const auto in = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() % 100'001) / 100'000;
  };
  for (int path = 0; path < 300; ++path) {
    std::vector<KinematicMove> moves;
    double angle = 0;
    for (int i = 0; i < 60; ++i) {
      angle += random() % 6 == 0 ? in(-3, 3) : in(-0.2, 0.2);
      moves.push_back(Towards(angle, std::pow(10, in(-2, 1)), in(10, 200)));
      moves.back().acceleration_mm_s2 = random() % 9 == 0 ? 500 : 2000;
    }
    JerkPlanner planner(Limits());
    const auto profiles = planner.Plan(moves);
    for (size_t i = 0; i < moves.size(); ++i) {
      const MoveProfile& profile = profiles[i];
      ASSERT_GE(profile.time_s, moves[i].length_mm / moves[i].speed_mm_s * (1 - 1e-9));
      ASSERT_LE(profile.cruise_mm_s, moves[i].speed_mm_s * (1 + 1e-9));
      ASSERT_NEAR(profile.entry_mm_s, i > 0 ? profiles[i - 1].exit_mm_s : 0, 1e-9);
      // Ramps with infinite jerk are a lower bound of the length.
      const double change =
          std::abs(std::pow(profile.exit_mm_s, 2) - std::pow(profile.entry_mm_s, 2));
      ASSERT_LE(change, 2 * moves[i].acceleration_mm_s2 * moves[i].length_mm * (1 + 1e-6) + 1e-9);
    }
  }
}

TEST(JerkPlanner, MoreJerkIsFaster) {
  std::vector<KinematicMove> moves;
  for (int i = 0; i < 50; ++i) moves.push_back(Towards(0.7 * i * i, 3 + i % 7));
  double before = TimeOf(moves, 1e4);
  for (const double jerk : {3e4, 1e5, 1e6}) {
    const double time_s = TimeOf(moves, jerk);
    EXPECT_LT(time_s, before);
    before = time_s;
  }
}

TEST(JerkPlanner, NothingToDo) {
  JerkPlanner planner(Limits());
  EXPECT_TRUE(planner.Stop().empty());
}

}  // namespace
}  // namespace slicefarm::jerk_planner_test
