#include "services/motion/algo/toolpath/cooling.h"

#include <gtest/gtest.h>

#include <numeric>

#include "common/model/options/motion_options.h"
#include "common/model/options/tool_row.h"
#include "services/motion/algo/toolpath/print_speed.h"
#include "services/motion/algo/toolpath/toolpath_builder.h"

namespace slicefarm::motion::cooling_test {
namespace {

/// Returns `count` squares of 15 mm per side, 40 mm apart.
Toolpath Squares(int count) {
  static const MotionOptions options;
  ToolpathBuilder builder(options, {2, 600'000, 200'000}, 200'000);
  for (int i = 0; i < count; ++i) {
    Path path;
    path.feature = Feature::kExternalPerimeter;
    path.closed = true;
    const Coord x = i * 40 * kNmPerMm;
    const Coord side = 15 * kNmPerMm;
    path.points = {{x, 0}, {x + side, 0}, {x + side, side}, {x, side}};
    path.widths_nm = {450'000};
    builder.Add(path);
  }
  return builder.Finish();
}

double Sum(std::span<const double> times) {
  return std::accumulate(times.begin(), times.end(), 0.0);
}

double Time(const Toolpath& path) {
  LayerTiming timing(FirmwareOf(GcodeFlavor::kMarlin2), {});
  const MoveSpan whole = {&path, 0, path.moves.size(), {}};
  return Sum(timing.Times({&whole, 1}));
}

/// Slows `path` down and returns its new time.
double Slowed(const CoolingOptions& cooling, Toolpath& path) {
  LayerTiming timing(FirmwareOf(GcodeFlavor::kMarlin2), {});
  const MoveSpan whole = {&path, 0, path.moves.size(), {}};
  return Sum(SlowDown(cooling, {&whole, 1}, timing, {&path, 1}));
}

TEST(SlowDown, ReachesTheTimeAsThePlannerReckons) {
  CoolingOptions cooling;
  cooling.min_print_speed_mm_s = 1;
  for (const double wanted : {3.0, 5.0, 20.0}) {
    cooling.slowdown_below_layer_time_s = wanted;
    Toolpath path = Squares(1);
    ASSERT_LT(Time(path), wanted);
    const double time = Slowed(cooling, path);
    EXPECT_NEAR(time, wanted, 0.003 * wanted);
    EXPECT_DOUBLE_EQ(Time(path), time);
  }
}

/// Returns a line far inside, a line just before the outer wall, and the wall.
Toolpath InnerThenSurface() {
  static const MotionOptions options;
  ToolpathBuilder builder(options, {2, 600'000, 200'000}, 200'000);
  Path path;
  path.widths_nm = {450'000};
  path.feature = Feature::kInternalInfill;
  for (int i = 0; i < 20; ++i) {
    path.points = {{0, i * kNmPerMm}, {30 * kNmPerMm, i * kNmPerMm}};
    builder.Add(path);
  }
  path.feature = Feature::kExternalPerimeter;
  path.closed = true;
  path.points = {{0, 0}, {15 * kNmPerMm, 0}, {15 * kNmPerMm, 15 * kNmPerMm}};
  builder.Add(path);
  return builder.Finish();
}

std::vector<int32_t> FeedRates(const Toolpath& path, bool surface) {
  std::vector<int32_t> rates;
  for (const Move& move : path.moves)
    if (move.kind == MoveKind::kPrint && move.of_surface == surface)
      rates.push_back(move.feed_rate);
  return rates;
}

TEST(SlowDown, TheSurfaceStaysAsFastAsItMay) {
  CoolingOptions cooling;
  cooling.consistent_surface = true;
  cooling.transition_mm = 10;
  cooling.min_print_speed_mm_s = 10;
  const Toolpath full = InnerThenSurface();
  const double full_time = Time(full);
  cooling.slowdown_below_layer_time_s = 2 * full_time;
  Toolpath path = full;
  EXPECT_NEAR(Slowed(cooling, path), 2 * full_time, 0.01 * full_time);
  EXPECT_EQ(FeedRates(path, true), FeedRates(full, true));
  std::vector<int32_t> inner = FeedRates(path, false), inner_full = FeedRates(full, false);
  EXPECT_EQ(inner.back(), inner_full.back()) << "just before the surface";
  EXPECT_LT(inner.front(), inner_full.front());

  // The inner beads are not enough, so the surface is slowed down too.
  cooling.slowdown_below_layer_time_s = 9 * full_time;
  path = full;
  Slowed(cooling, path);
  EXPECT_EQ(FeedRates(path, false).front(), FeedRate(10));
  EXPECT_LT(FeedRates(path, true).front(), FeedRates(full, true).front());

  // Without the setting all beads are treated alike.
  cooling.consistent_surface = false;
  cooling.slowdown_below_layer_time_s = 2 * full_time;
  path = full;
  Slowed(cooling, path);
  EXPECT_LT(FeedRates(path, true).front(), FeedRates(full, true).front());
}

TEST(SlowDown, LongLayersAndSwitchedOffCoolingStayAsTheyAre) {
  CoolingOptions cooling;
  Toolpath path = Squares(20);
  const Toolpath before = path;
  EXPECT_DOUBLE_EQ(Slowed(cooling, path), Time(before));
  EXPECT_EQ(path.moves, before.moves);
  cooling.enabled = false;
  Toolpath small = Squares(1);
  Slowed(cooling, small);
  EXPECT_EQ(small.moves, Squares(1).moves);
}

TEST(SlowDown, NotBelowTheLeastSpeed) {
  CoolingOptions cooling;
  cooling.slowdown_below_layer_time_s = 1'000;
  cooling.min_print_speed_mm_s = 12;
  Toolpath path = Squares(1);
  EXPECT_LT(Slowed(cooling, path), 1'000);
  for (const Move& move : path.moves) {
    if (move.kind != MoveKind::kPrint) continue;
    EXPECT_EQ(move.feed_rate, FeedRate(12));
  }
}

TEST(SlowDown, BeadsThatAreSlowerAlreadyAreNotSpedUp) {
  CoolingOptions cooling;
  cooling.slowdown_below_layer_time_s = 1'000;
  cooling.min_print_speed_mm_s = 50;  // above the 30 mm/s of the squares
  Toolpath path = Squares(1);
  Slowed(cooling, path);
  EXPECT_EQ(path.moves, Squares(1).moves);
}

TEST(SlowDown, TravelsKeepTheirSpeed) {
  CoolingOptions cooling;
  cooling.slowdown_below_layer_time_s = 60;
  Toolpath path = Squares(2);
  const Toolpath before = path;
  Slowed(cooling, path);
  for (size_t i = 0; i < path.moves.size(); ++i) {
    if (path.moves[i].kind == MoveKind::kPrint) continue;
    EXPECT_EQ(path.moves[i], before.moves[i]);
  }
}

TEST(SlowDown, CopiesAndTravelBetweenThemCount) {
  CoolingOptions cooling;
  cooling.min_print_speed_mm_s = 1;
  cooling.slowdown_below_layer_time_s = 30;
  LayerTiming timing(FirmwareOf(GcodeFlavor::kMarlin2), {});
  Toolpath paths[] = {Squares(1), Squares(2)};
  std::vector<MoveSpan> program;
  for (const size_t path : {0, 0, 0, 1})
    program.push_back({&paths[path], 0, paths[path].moves.size(), {30'000, 0}});
  EXPECT_NEAR(Sum(SlowDown(cooling, program, timing, paths)), 30, 0.003 * 30);
}

TEST(SlowDown, EmptyLayer) {
  Toolpath path;
  EXPECT_EQ(Slowed({}, path), 0);
}

TEST(FanPercent, GoesWithTheLayersTime) {
  CoolingOptions cooling;  // fan 35..100 %, layer times 5..60 s
  EXPECT_EQ(FanPercent(cooling, 0, 3), 0) << "first layers";
  EXPECT_EQ(FanPercent(cooling, 1, 3), 100);
  EXPECT_EQ(FanPercent(cooling, 1, 5), 100);
  EXPECT_EQ(FanPercent(cooling, 1, 32.5), 68);
  EXPECT_EQ(FanPercent(cooling, 1, 60), 35);
  cooling.fan_always_on = false;
  EXPECT_EQ(FanPercent(cooling, 1, 61), 0);
  EXPECT_EQ(FanPercent(cooling, 1, 3), 100);
  cooling.fan_always_on = true;
  cooling.enabled = false;
  EXPECT_EQ(FanPercent(cooling, 1, 3), 35);
}

TEST(BridgeFanPercent, IsNoLessThanTheFan) {
  CoolingOptions cooling;
  EXPECT_EQ(BridgeFanPercent(cooling, 1, 35), 100);
  EXPECT_EQ(BridgeFanPercent(cooling, 0, 0), 0);
  cooling.bridge_fan_percent = 20;
  EXPECT_EQ(BridgeFanPercent(cooling, 1, 35), 35);
  cooling.bridge_fan_percent = -1;  // the fan of the layer
  EXPECT_EQ(BridgeFanPercent(cooling, 1, 0), 0);
  EXPECT_EQ(BridgeFanPercent(cooling, 1, 35), 35);
}

TEST(FanPercent, GrowsUpToTheFullLayer) {
  CoolingOptions cooling;
  cooling.disable_fan_first_layers = 2;
  cooling.full_fan_speed_layer = 6;
  for (const auto& [layer, want] : {std::pair{1, 0}, {2, 25}, {3, 50}, {4, 75}, {5, 100}, {9, 100}})
    EXPECT_EQ(FanPercent(cooling, layer, 1), want) << layer;
  EXPECT_EQ(BridgeFanPercent(cooling, 3, 20), 50);
  cooling.disable_fan_first_layers = 0;
  EXPECT_EQ(FanPercent(cooling, 0, 1), 0);
}

TEST(CooledRest, IsWhatTheThresholdLeaves) {
  CoolingOptions cooling;
  EXPECT_EQ(CooledRest(cooling), -1);
  for (const auto& [share, rest] : {std::pair{0.95, 5}, {0.75, 25}, {0.1, 90}, {0.0, 100}}) {
    cooling.overhang_fan_share = share;
    EXPECT_EQ(CooledRest(cooling), rest);
  }
}

TEST(LineFanPercent, AfterTheFirstLayers) {
  CoolingOptions cooling;
  EXPECT_EQ(LineFanPercent(cooling, 5), LineFans{});
  cooling.interface_fan_percent = 0;
  cooling.ironing_fan_percent = 20;
  cooling.internal_bridge_fan_percent = 70;
  EXPECT_EQ(LineFanPercent(cooling, 0), LineFans{});
  EXPECT_EQ(LineFanPercent(cooling, 1), (LineFans{0, 20, 70}));
  cooling.bridge_fan = false;
  EXPECT_EQ(LineFanPercent(cooling, 1), (LineFans{0, 20, -1}));
}

TEST(FanPercent, HasItsOwnSpeedInTheFirstLayer) {
  CoolingOptions cooling;
  cooling.first_layer_fan_percent = 30;
  EXPECT_EQ(FanPercent(cooling, 0, 1), 0) << "the first layers have no fan";
  cooling.disable_fan_first_layers = 0;
  cooling.ironing_fan_percent = 20;
  EXPECT_EQ(FanPercent(cooling, 0, 1), 30);
  EXPECT_EQ(BridgeFanPercent(cooling, 0, 30), 30);
  EXPECT_EQ(LineFanPercent(cooling, 0), LineFans{});
  EXPECT_EQ(FanPercent(cooling, 1, 1), 100);
  cooling.full_fan_speed_layer = 5;
  for (const auto& [layer, want] :
       {std::pair{0, 30}, {1, 48}, {2, 65}, {3, 83}, {4, 100}, {9, 100}})
    EXPECT_EQ(FanPercent(cooling, layer, 1), want) << layer;
}

TEST(IsOffBefore, OnlyIfTheTimesDoNotMatter) {
  CoolingOptions cooling;
  cooling.disable_fan_first_layers = 2;
  EXPECT_TRUE(IsOffBefore(cooling, 0));
  EXPECT_TRUE(IsOffBefore(cooling, 2));
  EXPECT_FALSE(IsOffBefore(cooling, 3));
}

TEST(OverhangFanPercent, OnlyIfAskedFor) {
  CoolingOptions cooling;
  cooling.overhang_fan_percent = {100, 80, 40, 10};
  EXPECT_FALSE(OverhangFanPercent(cooling, 5, 0));
  cooling.dynamic_fan = true;
  EXPECT_EQ(*OverhangFanPercent(cooling, 5, 0), (OverhangFans{100, 80, 40, 10}));
  EXPECT_EQ(*OverhangFanPercent(cooling, 0, 0), (OverhangFans{0, 0, 0, 0}));
}

TEST(OverhangFanPercent, IsNoLessThanTheFan) {
  CoolingOptions cooling;
  cooling.dynamic_fan = true;
  cooling.overhang_fan_percent = {100, 50, 0, 0};
  EXPECT_EQ(*OverhangFanPercent(cooling, 5, 70), (OverhangFans{100, 70, 70, 70}));
}

TEST(SlowDown, OuterWallsKeepTheirSpeedIfAskedFor) {
  CoolingOptions cooling;
  cooling.slowdown_below_layer_time_s = 30;
  cooling.min_print_speed_mm_s = 1;
  cooling.keep_outer_walls = true;
  Toolpath path = Squares(2);
  for (size_t i = path.moves.size() / 2; i < path.moves.size(); ++i)
    path.moves[i].feature = Feature::kPerimeter;
  const Toolpath full = path;
  EXPECT_NEAR(Slowed(cooling, path), 30, 0.1);
  int kept = 0, slowed = 0;
  for (size_t i = 0; i < path.moves.size(); ++i) {
    if (path.moves[i].kind != MoveKind::kPrint) continue;
    const bool outer = path.moves[i].feature == Feature::kExternalPerimeter;
    EXPECT_EQ(path.moves[i].feed_rate == full.moves[i].feed_rate, outer) << i;
    ++(outer ? kept : slowed);
  }
  EXPECT_GT(kept, 0);
  EXPECT_GT(slowed, 0);
  Toolpath outer_only = Squares(1);
  const Toolpath before = outer_only;
  Slowed(cooling, outer_only);
  EXPECT_EQ(outer_only.moves, before.moves) << "nothing else to slow down";
}

TEST(BridgeFanPercent, IsTheLayersFanWithoutABridgeFan) {
  CoolingOptions cooling;
  cooling.disable_fan_first_layers = 0;
  cooling.bridge_fan_percent = 100;
  EXPECT_EQ(BridgeFanPercent(cooling, 5, 40), 100);
  cooling.bridge_fan = false;
  EXPECT_EQ(BridgeFanPercent(cooling, 5, 40), 40);
}

}  // namespace
}  // namespace slicefarm::motion::cooling_test
