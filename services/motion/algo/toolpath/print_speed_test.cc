#include "services/motion/algo/toolpath/print_speed.h"

#include <gtest/gtest.h>

#include "common/model/options/motion_options.h"

namespace slicefarm::motion::print_speed_test {
namespace {

MotionOptions Options() {
  MotionOptions options;
  options.speeds[0].speed_mm_s = {40, 60, 30, 20, 80, 70, 50, 45, 60, 60, 60, 15, 33};
  options.speeds[0].small_perimeter_speed_mm_s = 15;
  options.first_layer_speed_mm_s = 25;
  options.max_print_speed_mm_s = 77;
  return options;
}

Path OfFeature(Feature feature, bool closed = false) {
  Path path;
  path.feature = feature;
  path.closed = closed;
  return path;
}

TEST(PrintSpeeds, ByFeature) {
  const MotionOptions options = Options();
  const PrintSpeeds speeds(options, Ground::kLayers);
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kExternalPerimeter), 100), 40);
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kInternalInfill), 1), 80);
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kSolidOverBridge), 1), 33);
}

TEST(PrintSpeeds, BridgesOverSparseInfill) {
  MotionOptions options = Options();
  const PrintSpeeds speeds(options, Ground::kLayers);
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kInternalBridge), 1), 45) << "as other bridges";
  options.speeds[0].speed_mm_s[static_cast<size_t>(Feature::kInternalBridge)] = 22;
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kInternalBridge), 1), 22);
}

TEST(PrintSpeeds, SmallWalls) {
  const MotionOptions options = Options();
  const PrintSpeeds speeds(options, Ground::kLayers);
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kPerimeter, true), 40.8), 15);
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kPerimeter, true), 40.9), 60);
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kPerimeter, false), 10), 15);
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kGapFill, true), 10), 20);
}

TEST(PrintSpeeds, SmallSupports) {
  MotionOptions options = Options();
  const PrintSpeeds speeds(options, Ground::kLayers);
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kSupport, true), 1), 60);
  options.speeds[0].small_support_radius_mm = 2;
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kSupport, true), 12.5), 30) << "half of the speed";
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kSupport, true), 12.6), 60);
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kSupport, false), 1), 60);
  options.speeds[0].small_support_mm_s = 12;
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kSupportInterface, true), 1), 12);
}

TEST(PrintSpeeds, OutsideResonance) {
  MotionOptions options = Options();
  options.resonance = {.avoid = false, .from_mm_s = 70, .until_mm_s = 120};
  const PrintSpeeds speeds(options, Ground::kLayers);
  const auto wall = [&](double speed) {
    return speeds.OutsideResonance(Feature::kExternalPerimeter, speed);
  };
  EXPECT_EQ(wall(100), 100);
  options.resonance.avoid = true;
  for (const auto& [speed, want] :
       {std::pair{60.0, 60.0}, {70.0, 70.0}, {71.0, 70.0}, {120.0, 70.0}, {121.0, 121.0}})
    EXPECT_EQ(wall(speed), want) << speed;
  EXPECT_EQ(speeds.OutsideResonance(Feature::kPerimeter, 100), 100);
}

TEST(PrintSpeeds, SmallWallsByRadius) {
  MotionOptions options = Options();
  const PrintSpeeds speeds(options, Ground::kLayers);
  options.speeds[0].small_perimeter_radius_mm = 2;
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kPerimeter, true), 12.5), 15);
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kPerimeter, true), 12.6), 60);
  options.speeds[0].small_perimeter_radius_mm = 0;
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kPerimeter, true), 1), 60);
}

TEST(PrintSpeeds, RiseOverTheFirstLayers) {
  MotionOptions options = Options();
  options.first_layer_infill_speed_mm_s = 40;
  options.slow_down_layers = 5;
  struct Case {
    int32_t layer;
    Feature feature;
    double want;
  };
  for (const auto& [layer, feature, want] : {Case{0, Feature::kPerimeter, 25},
                                             {1, Feature::kPerimeter, 32},
                                             {4, Feature::kPerimeter, 53},
                                             {5, Feature::kPerimeter, 60},
                                             {1, Feature::kInternalInfill, 48},
                                             {1, Feature::kGapFill, 20}}) {
    const Ground ground = layer == 0 ? Ground::kBed : Ground::kLayers;
    EXPECT_DOUBLE_EQ(PrintSpeeds(options, ground, layer).Of(OfFeature(feature), 100), want)
        << layer << FeatureName(feature);
  }
}

TEST(PrintSpeeds, FirstLayersInfill) {
  MotionOptions options = Options();
  options.first_layer_infill_speed_mm_s = 35;
  const PrintSpeeds speeds(options, Ground::kBed);
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kSolidInfill), 100), 35);
  EXPECT_EQ(speeds.Of(OfFeature(Feature::kPerimeter), 100), 25);
  EXPECT_EQ(PrintSpeeds(options, Ground::kLayers).Of(OfFeature(Feature::kSolidInfill), 100), 70);
}

TEST(PrintSpeeds, FirstLayerOnARaft) {
  MotionOptions options = Options();
  options.over_raft_speed_mm_s = 33;
  EXPECT_EQ(PrintSpeeds(options, Ground::kRaft).Of(OfFeature(Feature::kPerimeter), 100), 33);
  options.over_raft_speed_mm_s = 0;
  options.over_raft_speed_ratio = 0.5;
  EXPECT_EQ(PrintSpeeds(options, Ground::kRaft).Of(OfFeature(Feature::kPerimeter), 100), 30);
}

TEST(PrintSpeeds, WallsOverAirAreSlower) {
  MotionOptions options = Options();
  const PrintSpeeds speeds(options, Ground::kLayers);
  const Path path = OfFeature(Feature::kExternalPerimeter);
  EXPECT_EQ(speeds.OverAir(path, 40, 0), 40) << "not asked for";
  options.speeds[0].dynamic_overhangs = true;
  options.speeds[0].overhang_speed_mm_s = {10, 0, 20, 90};
  EXPECT_EQ(speeds.OverAir(path, 40, 0), 10);
  EXPECT_EQ(speeds.OverAir(path, 40, 25), 40) << "0: not slowed down";
  EXPECT_EQ(speeds.OverAir(path, 40, 50), 20);
  EXPECT_EQ(speeds.OverAir(path, 40, 75), 40) << "never faster";
  EXPECT_EQ(speeds.OverAir(path, 40, kFullRest), 40);
}

TEST(PrintSpeeds, FirstLayer) {
  MotionOptions options = Options();
  EXPECT_EQ(PrintSpeeds(options, Ground::kBed).Of(OfFeature(Feature::kPerimeter), 100), 25);
  options.first_layer_speed_mm_s = 0;
  options.first_layer_speed_ratio = 0.5;
  EXPECT_EQ(PrintSpeeds(options, Ground::kBed).Of(OfFeature(Feature::kPerimeter), 100), 30);
}

TEST(PrintSpeeds, EachRegionHasItsOwn) {
  MotionOptions options = Options();
  options.speeds.push_back(options.speeds[0]);
  options.speeds[1].speed_mm_s[static_cast<size_t>(Feature::kPerimeter)] = 33;
  Path path = OfFeature(Feature::kPerimeter);
  path.settings = 1;
  EXPECT_EQ(PrintSpeeds(options, Ground::kLayers).Of(path, 100), 33);
  path.settings = 0;
  EXPECT_EQ(PrintSpeeds(options, Ground::kLayers).Of(path, 100), 60);
}

TEST(PrintSpeeds, Defaults) {
  MotionOptions options = Options();
  const Path path = OfFeature(Feature::kPerimeter);
  options.speeds[0].speed_mm_s = {};
  EXPECT_EQ(PrintSpeeds(options, Ground::kLayers).Of(path, 100), 77);
  options.max_print_speed_mm_s = 0;
  EXPECT_GT(PrintSpeeds(options, Ground::kLayers).Of(path, 100), 0);
}

TEST(PrintSpeeds, VolumePerSecond) {
  MotionOptions options = Options();
  const auto limited = [&](double speed_mm_s, Coord width_nm = 500'000) {
    const PrintSpeeds speeds(options, Ground::kLayers);
    return PrintSpeeds::LimitedByFlow(speed_mm_s, 0.1, speeds.LargestFlow(width_nm, 200'000));
  };
  EXPECT_EQ(limited(60), 60);
  options.tool().max_volumetric_speed_mm3_s = 4;
  EXPECT_EQ(limited(60), 40);
  EXPECT_EQ(limited(30), 30);
  options.tool().flow_fit = "0 0 0 0 5 0.5";  // 3 mm3/s for a width of 0.5, 5.5 for 1
  EXPECT_NEAR(limited(60), 30, 1e-9);
  EXPECT_EQ(limited(60, 1'000'000), 40) << "the fixed limit remains";
  options.tool().max_volumetric_speed_mm3_s = 0;
  EXPECT_NEAR(limited(60, 1'000'000), 55, 1e-9);
}

TEST(TravelSpeed, OfZFallsBackToTheMachine) {
  MotionOptions options = Options();
  options.limits.max_feedrate_mm_s[2] = 12;
  EXPECT_EQ(TravelSpeedZ(options), 12);
  options.travel_speed_z_mm_s = 5;
  EXPECT_EQ(TravelSpeedZ(options), 5);
}

TEST(FeedRate, IsWholeAndPositive) {
  EXPECT_EQ(FeedRate(35), 2'100);
  EXPECT_EQ(FeedRate(0), 1);
  EXPECT_EQ(FeedRate(1e300), 1'000'000);
}

TEST(PrintSpeeds, SkirtsHaveTheirOwnInAllLayers) {
  MotionOptions options;
  options.speeds[0].skirt_speed_mm_s = 45;
  Path skirt;
  skirt.feature = Feature::kSkirt;
  for (const Ground ground : {Ground::kBed, Ground::kLayers})
    EXPECT_EQ(PrintSpeeds(options, ground).Of(skirt, 100), 45);
  skirt.feature = Feature::kSupport;
  EXPECT_NE(PrintSpeeds(options, Ground::kLayers).Of(skirt, 100), 45);
}

}  // namespace
}  // namespace slicefarm::motion::print_speed_test
