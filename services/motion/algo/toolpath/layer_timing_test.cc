#include "services/motion/algo/toolpath/layer_timing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "common/kinematics/trapezoid.h"

namespace slicefarm::motion::layer_timing_test {
namespace {

/// Returns these moves: up by 0.2, over to x = 100 from anywhere, unretract, print 100 mm back,
/// retract.
Toolpath Sample() {
  Toolpath path;
  path.start_z_um = 200;
  Move move;
  move.acceleration_mm_s2 = 3000;
  move.z_um = 400;
  move.kind = MoveKind::kLift;
  move.feed_rate = 600;
  path.moves.push_back(move);
  move.kind = MoveKind::kTravel;
  move.x_um = 100'000;
  move.feed_rate = 6'000;
  path.approach = 1;
  path.moves.push_back(move);
  move.kind = MoveKind::kRestart;
  move.filament = 80'000;
  path.moves.push_back(move);
  move.kind = MoveKind::kPrint;
  move.feature = Feature::kSolidInfill;
  move.x_um = 0;
  move.filament = 300'000;
  path.moves.push_back(move);
  move.kind = MoveKind::kRetract;
  move.filament = -80'000;
  path.moves.push_back(move);
  return path;
}

TEST(LayerTiming, MovesFromRestToRest) {
  MachineLimits limits;
  limits.max_acceleration_mm_s2 = {3000, 3000, 500, 1000};
  LayerTiming timing(FirmwareOf(GcodeFlavor::kKlipper), limits);
  const Toolpath path = Sample();
  const MoveSpan whole = {&path, 0, path.moves.size(), {}};
  const auto times = timing.Times({&whole, 1});
  ASSERT_EQ(times.size(), 5);
  EXPECT_NEAR(times[0], RestToRest(0.2, 10, 500), 1e-9);
  EXPECT_EQ(times[1], 0) << "the approach is not known";
  EXPECT_NEAR(times[3], RestToRest(100, 100, 3000), 1e-9) << "the toolhead stops at retractions";
  EXPECT_EQ(times[2], times[4]);
}

TEST(LayerTiming, NothingToDo) {
  LayerTiming timing(FirmwareOf(GcodeFlavor::kMarlin2), {});
  EXPECT_TRUE(timing.Times({}).empty());
}

// A travel from copy to copy starts where the copy before ends.
TEST(LayerTiming, KnowsTheWayToOtherCopies) {
  MachineLimits limits;
  limits.max_acceleration_mm_s2 = {3000, 3000, 500, 1000};
  LayerTiming timing(FirmwareOf(GcodeFlavor::kKlipper), limits);
  const Toolpath path = Sample();
  const MoveSpan program[] = {{&path, 0, 5, {}}, {&path, path.approach, 5, {0, 30'000}}};
  const auto times = timing.Times(program);
  ASSERT_EQ(times.size(), 9);
  EXPECT_NEAR(times[5], RestToRest(std::hypot(100, 30), 100, 3000), 1e-9);
  EXPECT_EQ(times[7], times[3]);
}

// If all moves share one acceleration, the travel to a copy has the acceleration of the bead before
// it.
TEST(LayerTiming, MovesWithoutTheirOwnAccelerationHaveTheOneBefore) {
  MachineLimits limits;
  limits.max_acceleration_mm_s2 = {9000, 9000, 9000, 9000};
  LayerTiming timing(FirmwareOf(GcodeFlavor::kKlipper), limits);
  Toolpath path = Sample();
  path.moves[0].acceleration_mm_s2 = path.moves[1].acceleration_mm_s2 = 0;
  Toolpath other = path;
  other.moves[3].acceleration_mm_s2 = 500;
  const MoveSpan program[] = {{&path, 0, 5, {}}, {&other, 0, 5, {0, 30'000}}, {&path, 1, 5, {}}};
  const auto times = timing.Times(program);
  EXPECT_NEAR(times[0], RestToRest(0.2, 10, 3000), 1e-9) << "as the first bead";
  EXPECT_EQ(times[5], 0) << "is at that height";
  EXPECT_NEAR(times[6], RestToRest(std::hypot(100, 30), 100, 3000), 1e-9);
  EXPECT_NEAR(times[10], RestToRest(std::hypot(100, 30), 100, 500), 1e-9);
}

// A firmware divides an arc into chords of its own. Here half a circle of 10 mm becomes chords of 1
// mm. Their corners slow the nozzle down if they may not deviate.
TEST(LayerTiming, ArcsAreTheFirmwaresChords) {
  Toolpath path = Sample();
  Move bead = path.moves[3];
  path.moves.resize(3);
  constexpr int kMoves = 1'000;
  for (int i = 1; i <= kMoves; ++i) {
    const double angle = i * std::numbers::pi / kMoves;
    bead.x_um = static_cast<int32_t>(std::lround(90'000 + 10'000 * std::cos(angle)));
    bead.y_um = static_cast<int32_t>(std::lround(10'000 * std::sin(angle)));
    bead.filament = 3'000;
    path.moves.push_back(bead);
  }
  const auto time_of = [&path](double deviation_mm) {
    MachineLimits limits;
    limits.junction_deviation_mm = deviation_mm;
    LayerTiming timing(FirmwareOf(GcodeFlavor::kMarlin2), limits);
    const MoveSpan whole = {&path, 0, path.moves.size(), {}};
    const auto times = timing.Times({&whole, 1});
    EXPECT_EQ(times.size(), path.moves.size());
    return std::accumulate(times.begin() + 3, times.end(), 0.0);
  };
  path.arcs = {{3, path.moves.size(), {90'000, 0}, false}};
  const double full_speed_s = 10 * std::numbers::pi / 100;
  EXPECT_NEAR(time_of(1), full_speed_s, 0.1 * full_speed_s) << "and a ramp at each end";
  EXPECT_GT(time_of(1e-4), 1.5 * full_speed_s);
}

TEST(AddTimes, ByFeatureAndTravel) {
  const Toolpath path = Sample();
  LayerTiming timing(FirmwareOf(GcodeFlavor::kMarlin2), {});
  const MoveSpan whole = {&path, 0, path.moves.size(), {}};
  const auto times = timing.Times({&whole, 1});
  ProgramStats stats;
  AddTimes({&whole, 1}, times, stats);
  EXPECT_EQ(stats.features[static_cast<size_t>(Feature::kSolidInfill)].time_s, times[3]);
  EXPECT_DOUBLE_EQ(stats.travel_time_s, times[0] + times[2] + times[4]);
  EXPECT_DOUBLE_EQ(stats.retract_time_s, times[2] + times[4]);
  EXPECT_DOUBLE_EQ(stats.TimeS(), std::accumulate(times.begin(), times.end(), 0.0));
}

/// Returns a square of 10 mm at 100 mm/s with this jerk.
Toolpath Square(float jerk_mm_s) {
  Toolpath path;
  Move move;
  move.feed_rate = 6'000;
  move.acceleration_mm_s2 = 1000;
  move.jerk_mm_s = jerk_mm_s;
  path.approach = 0;
  path.moves.push_back(move);
  move.kind = MoveKind::kPrint;
  move.filament = 30'000;
  for (const auto& [x_um, y_um] : {std::pair(10'000, 0), {10'000, 10'000}, {0, 10'000}, {0, 0}}) {
    move.x_um = x_um;
    move.y_um = y_um;
    path.moves.push_back(move);
  }
  return path;
}

TEST(LayerTiming, JerkOfMovesReplacesTheMachines) {
  for (const GcodeFlavor flavor :
       {GcodeFlavor::kMarlin2, GcodeFlavor::kKlipper, GcodeFlavor::kRepRapFirmware}) {
    const auto time = [&](float jerk_mm_s, double limit_mm_s) {
      MachineLimits limits;
      limits.max_jerk_mm_s = {limit_mm_s, limit_mm_s, 1, 50};
      limits.square_corner_velocity_mm_s = limit_mm_s;
      LayerTiming timing(FirmwareOf(flavor), limits);
      const Toolpath path = Square(jerk_mm_s);
      const MoveSpan whole = {&path, 0, path.moves.size(), {}};
      const auto times = timing.Times({&whole, 1});
      return std::accumulate(times.begin(), times.end(), 0.0);
    };
    EXPECT_LT(time(20, 5), time(0, 5)) << static_cast<int>(flavor);
    EXPECT_DOUBLE_EQ(time(20, 5), time(0, 20)) << static_cast<int>(flavor);
  }
}

}  // namespace
}  // namespace slicefarm::motion::layer_timing_test
