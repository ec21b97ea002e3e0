// Tests of the settings for walls, seams, travels and brims.
#include <gtest/gtest.h>

#include "common/config/resolve.h"
#include "common/config/setting_pairs_test.h"
#include "common/model/options/tool_row.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config::shapes_test {
namespace {

JobRows Job(const Pairs& pairs) {
  auto resolved = Resolve(Settings(pairs), Process::kFdm);
  if (!resolved.ok()) {
    ADD_FAILURE() << resolved.status();
    return {};
  }
  return std::move(resolved->settings);
}

TEST(ResolveShapes, ReadsWhatShapesWalls) {
  const JobRows settings = Job({{"slicing_mode", "close_holes"},
                                {"overhangs", "0"},
                                {"top_one_perimeter_type", "top"},
                                {"fuzzy_skin", "all"},
                                {"fuzzy_skin_thickness", "0.2"},
                                {"fuzzy_skin_point_dist", "0.5"},
                                {"prefer_clockwise_movements", "1"},
                                {"seam_gap_distance", "15%"},
                                {"nozzle_diameter", "0.6"}});
  EXPECT_TRUE(settings.object.close_holes);
  EXPECT_EQ(settings.object.fill_rule, FillRule::kNonZero);
  EXPECT_FALSE(FdmOf(settings).region.motion.bridging_walls);
  EXPECT_EQ(FdmOf(settings).region.walls.one_on_top, OneWallOnTop::kSurfaces);
  EXPECT_EQ(FdmOf(settings).region.walls.fuzzy, FuzzySkin::kAllWalls);
  EXPECT_EQ(FdmOf(settings).region.walls.fuzzy_thickness_nm, 200'000);
  EXPECT_EQ(FdmOf(settings).region.walls.fuzzy_point_distance_nm, 500'000);
  EXPECT_TRUE(FdmOf(settings).machine.order.clockwise);
  EXPECT_NEAR(FdmOf(settings).machine.motion.seam_gap_mm, 0.09, 1e-9);
  EXPECT_TRUE(FdmOf(Job({})).region.motion.bridging_walls);
}

TEST(ResolveShapes, ExtraWallsNeedInfill) {
  const auto extra = [](const char* density) {
    return FdmOf(Job({{"extra_perimeters", "1"}, {"fill_density", density}}))
        .region.walls.extra_perimeters;
  };
  EXPECT_TRUE(extra("5%"));
  EXPECT_FALSE(extra("0"));
}

TEST(ResolveShapes, FilamentsOverrideRampsAndGaps) {
  const JobRows settings = Job({{"travel_ramping_lift", "0"},
                                {"filament_travel_ramping_lift", "1"},
                                {"travel_max_lift", "0.4"},
                                {"filament_travel_max_lift", "1.5"},
                                {"travel_slope", "3"},
                                {"filament_travel_slope", "nil"},
                                {"filament_travel_lift_before_obstacle", "1"},
                                {"seam_gap_distance", "0.1"},
                                {"filament_seam_gap_distance", "25%"},
                                {"nozzle_diameter", "0.4"}});
  const RetractionOptions& retraction = FdmOf(settings).tool.retraction;
  EXPECT_TRUE(retraction.ramping);
  EXPECT_EQ(retraction.ramp_lift_mm, 1.5);
  EXPECT_EQ(retraction.ramp_slope_deg, 3);
  EXPECT_TRUE(retraction.before_obstacles);
  EXPECT_NEAR(FdmOf(settings).machine.motion.seam_gap_mm, 0.1, 1e-9);
}

TEST(ResolveShapes, AutomaticBrimsKnowTheMaterial) {
  const auto brim = [](const char* type, const char* filament) {
    return FdmOf(Job({{"brim_type", type},
                      {"filament_type", filament},
                      {"perimeter_speed", "90"},
                      {"infill_speed", "120"}}))
        .object.brim;
  };
  EXPECT_EQ(brim("auto_brim", "PLA").automatic, (AutomaticBrim{true, 200, 1, 120}));
  EXPECT_EQ(brim("auto_brim", "ABS").automatic, (AutomaticBrim{true, 100, 1, 120}));
  EXPECT_EQ(brim("auto_brim", "PETG").automatic, (AutomaticBrim{true, 200, 2, 120}));
  EXPECT_EQ(brim("auto_brim", "PLA").type, BrimType::kOuterOnly);
  EXPECT_FALSE(brim("outer_only", "PLA").automatic.on);
}

}  // namespace
}  // namespace slicefarm::config::shapes_test
