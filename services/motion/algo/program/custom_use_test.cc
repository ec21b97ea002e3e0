#include "services/motion/algo/program/custom_use.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/model/options/motion_options.h"

namespace slicefarm::motion::custom_use_test {
namespace {

TEST(UseOfCode, CountsBeadsAndTime) {
  MotionOptions options;
  const FeatureUse use = UseOfCode(
      "M900 K0.1\nG1 X100 Y50 F6000\nG1 E0.8 F2400\nG1 X140 Y80 E2 F1200\nG1 X140 Y90 F6000\n"
      "G1 E-0.8 F2400",
      options);
  EXPECT_NEAR(use.length_mm, 50, 1e-9);
  EXPECT_NEAR(use.filament_mm, 2, 1e-9);
  const double diameter_mm = options.tool().filament_diameter_mm;
  EXPECT_NEAR(use.volume_mm3, 2 * std::numbers::pi / 4 * diameter_mm * diameter_mm, 1e-9);
  EXPECT_GT(use.time_s, 2.5) << "50 mm at 20 mm/s";
  EXPECT_LT(use.time_s, 3.5) << "the travel to the first point is not counted";
}

TEST(UseOfCode, AbsoluteFilamentIsNotAddedUp) {
  MotionOptions options;
  options.writing.relative_e = false;
  EXPECT_NEAR(UseOfCode("G92 E0\nG1 X10 E1 F600\nG1 X20 E2\n", options).filament_mm, 2, 1e-9);
}

TEST(UseOfCode, CodeWithoutMovesUsesNothing) {
  EXPECT_EQ(UseOfCode("M117 hello\nM106 S255\n", MotionOptions()), FeatureUse());
  EXPECT_EQ(UseOfCode("", MotionOptions()), FeatureUse());
}

}  // namespace
}  // namespace slicefarm::motion::custom_use_test
