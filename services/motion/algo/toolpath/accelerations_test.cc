#include "services/motion/algo/toolpath/accelerations.h"

#include <gtest/gtest.h>

#include "common/model/options/machine_limits.h"
#include "common/model/options/motion_options.h"

namespace slicefarm::motion::accelerations_test {
namespace {

MotionOptions Options() {
  MotionOptions options;
  options.limits.max_acceleration_extruding_mm_s2 = 1500;
  options.limits.max_acceleration_travel_mm_s2 = 3000;
  options.limits.max_acceleration_retracting_mm_s2 = 1200;
  return options;
}

TEST(Accelerations, LeftToTheFirmware) {
  MotionOptions options = Options();
  options.acceleration_mm_s2[0] = 500;  // no effect without default_acceleration
  const Accelerations a = AccelerationsFor(options, Ground::kLayers);
  EXPECT_FALSE(a.written);
  EXPECT_EQ(a.Print(Feature::kExternalPerimeter), 1500);
  EXPECT_EQ(a.travel, 3000);
  EXPECT_EQ(a.retract, 1200);
}

TEST(Accelerations, FeaturesThenDefault) {
  MotionOptions options = Options();
  options.default_acceleration_mm_s2 = 1000;
  options.acceleration_mm_s2[static_cast<size_t>(Feature::kExternalPerimeter)] = 500;
  const Accelerations a = AccelerationsFor(options, Ground::kLayers);
  EXPECT_TRUE(a.written);
  EXPECT_FALSE(a.travel_written);
  EXPECT_EQ(a.Print(Feature::kExternalPerimeter), 500);
  EXPECT_EQ(a.Print(Feature::kInternalInfill), 1000);
}

TEST(Accelerations, FirstLayer) {
  MotionOptions options = Options();
  options.default_acceleration_mm_s2 = 1000;
  options.first_layer_acceleration_mm_s2 = 300;
  EXPECT_EQ(AccelerationsFor(options, Ground::kBed).Print(Feature::kPerimeter), 300);
  EXPECT_EQ(AccelerationsFor(options, Ground::kLayers).Print(Feature::kPerimeter), 1000);
}

TEST(Accelerations, WipesAreTravelsToRepRapFirmwareAlone) {
  for (const GcodeFlavor flavor :
       {GcodeFlavor::kMarlin2, GcodeFlavor::kMarlinLegacy, GcodeFlavor::kKlipper,
        GcodeFlavor::kRepRapFirmware, GcodeFlavor::kPrusaBuddy, GcodeFlavor::kBambu}) {
    MotionOptions options = Options();
    options.flavor = flavor;
    EXPECT_EQ(AccelerationsFor(options, Ground::kLayers).Wipe(700),
              flavor == GcodeFlavor::kRepRapFirmware ? 3000 : 700);
  }
}

TEST(Accelerations, TravelApartOnlyInMarlin2) {
  for (const GcodeFlavor flavor : {GcodeFlavor::kMarlinLegacy, GcodeFlavor::kKlipper}) {
    MotionOptions options = Options();
    options.flavor = flavor;
    options.default_acceleration_mm_s2 = 1000;
    EXPECT_EQ(AccelerationsFor(options, Ground::kLayers).Travel(700), 700) << "as the path before";
    options.travel_acceleration_mm_s2 = 2000;
    EXPECT_EQ(AccelerationsFor(options, Ground::kLayers).Travel(700), 2000);
    EXPECT_TRUE(AccelerationsFor(options, Ground::kLayers).travel_written);
  }
}

TEST(Accelerations, KlipperHasOneForAllMoves) {
  MotionOptions options = Options();
  EXPECT_EQ(AccelerationsFor(options, Ground::kLayers).Retract(700), 1200);
  EXPECT_FALSE(AccelerationsFor(options, Ground::kLayers).one);
  options.flavor = GcodeFlavor::kKlipper;
  EXPECT_EQ(AccelerationsFor(options, Ground::kLayers).Retract(700), 700) << "what was set last";
  EXPECT_TRUE(AccelerationsFor(options, Ground::kLayers).one);
}

TEST(Accelerations, LimitsOfTravelsHoldWhereTheFirmwareHasThem) {
  MotionOptions options = Options();
  options.limits.emit_to_gcode = true;
  options.default_acceleration_mm_s2 = 1000;
  options.travel_acceleration_mm_s2 = 8000;
  options.first_layer_travel_acceleration_mm_s2 = 5000;
  options.flavor = GcodeFlavor::kMarlin2;
  EXPECT_EQ(AccelerationsFor(options, Ground::kLayers).travel, 3000);
  EXPECT_EQ(AccelerationsFor(options, Ground::kBed).travel, 3000);
  options.limits.emit_to_gcode = false;
  EXPECT_EQ(AccelerationsFor(options, Ground::kLayers).travel, 8000);
  options.limits.emit_to_gcode = true;
  options.flavor = GcodeFlavor::kMarlinLegacy;
  EXPECT_EQ(AccelerationsFor(options, Ground::kLayers).travel, 8000) << "no limit of travels";
}

TEST(Accelerations, LimitsThatAreEmittedHold) {
  MotionOptions options = Options();
  options.default_acceleration_mm_s2 = 9000;
  EXPECT_EQ(AccelerationsFor(options, Ground::kLayers).Print(Feature::kPerimeter), 9000);
  options.limits.emit_to_gcode = true;
  EXPECT_EQ(AccelerationsFor(options, Ground::kLayers).Print(Feature::kPerimeter), 1500);
}

TEST(Accelerations, NeverZero) {
  MotionOptions options;
  options.limits.max_acceleration_extruding_mm_s2 = 0;
  options.limits.max_acceleration_travel_mm_s2 = 0;
  options.limits.max_acceleration_retracting_mm_s2 = 0;
  const Accelerations a = AccelerationsFor(options, Ground::kLayers);
  EXPECT_GT(a.Print(Feature::kPerimeter), 0);
  EXPECT_GT(a.Travel(a.Print(Feature::kPerimeter)), 0);
  EXPECT_GT(a.retract, 0);
}

}  // namespace
}  // namespace slicefarm::motion::accelerations_test
