#include "services/cli/program/klipper_config.h"

#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::cli::klipper_config_test {
namespace {

constexpr char kConfig[] =
    "# a printer\n[printer]\nkinematics: corexy\nmax_velocity: 250  # mm/s\nmax_accel = 4000\n"
    "max_z_velocity: 15\nsquare_corner_velocity: 6\n[stepper_x]\nposition_max: 235\n[stepper_y]\n"
    "position_max: 230\nposition_min: -2\n[stepper_z]\nposition_max: 240\n[extruder]\n"
    "nozzle_diameter: 0.4\nfilament_diameter: 1.75\n[gcode_macro START]\ngcode:\n"
    "  {% set max_accel = 1 %}\n";

TEST(ReadKlipperConfig, WhatItSaysAndKlippersDefaults) {
  const auto setup = ReadKlipperConfig(kConfig);
  ASSERT_TRUE(setup.ok()) << setup.status();
  const MachineLimits& limits = setup->machine.limits;
  EXPECT_EQ(limits.max_feedrate_mm_s[0], 250);
  EXPECT_EQ(limits.max_feedrate_mm_s[2], 15);
  EXPECT_EQ(limits.max_acceleration_extruding_mm_s2, 4000);
  EXPECT_EQ(limits.max_acceleration_mm_s2[2], 4000) << "as max_accel";
  EXPECT_EQ(limits.square_corner_velocity_mm_s, 6);
  EXPECT_EQ(limits.minimum_cruise_ratio, 0.5);
  // A bead of 0.64 mm2 from filament of 2.4053 mm2.
  EXPECT_NEAR(limits.max_feedrate_mm_s[3], 250 * 0.266082, 1e-3);
  EXPECT_NEAR(limits.max_acceleration_mm_s2[3], 4000 * 0.266082, 1e-2);
  EXPECT_EQ(setup->bed[0], (Point{0, FromMm(-2)}));
  EXPECT_EQ(setup->bed[2], (Point{FromMm(235), FromMm(230)}));
  EXPECT_EQ(setup->max_height_mm, 240);
  EXPECT_EQ(setup->machine.arc_segment_mm, 1);
  const auto finer =
      ReadKlipperConfig(std::string(kConfig) + "[gcode_arcs]\nresolution: 0.1 # mm\n");
  ASSERT_TRUE(finer.ok()) << finer.status();
  EXPECT_EQ(finer->machine.arc_segment_mm, 0.1);
}

TEST(ReadKlipperConfig, ErrorsNameTheKey) {
  const auto missing = ReadKlipperConfig("[printer]\nmax_velocity: 250\n");
  EXPECT_EQ(DetailOf(missing.status()).reason, Reason::kSettingMalformed);
  EXPECT_EQ(DetailOf(missing.status()).metadata.at("setting"), "printer.max_accel");
  const auto text = ReadKlipperConfig("[printer]\nmax_velocity: fast\nmax_accel: 1\n");
  EXPECT_EQ(DetailOf(text.status()).metadata.at("setting"), "printer.max_velocity");
}

TEST(IsKlipperConfig, ByItsSection) {
  EXPECT_TRUE(IsKlipperConfig(kConfig));
  EXPECT_FALSE(IsKlipperConfig("# [printer]\nmachine_max_feedrate_x = 9\n"));
}

}  // namespace
}  // namespace slicefarm::cli::klipper_config_test
