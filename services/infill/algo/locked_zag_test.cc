#include "services/infill/algo/locked_zag.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::locked_zag_test {
namespace {

MultiPolygon BoxOf40() { return MakePolygonsOrDie("(0 0, 40 0, 40 40, 0 40)"); }

TEST(LockedZones, AreASkinAndASkeletonThatReachesIntoIt) {
  const LockedZagOptions options{.skin_density = 0.3,
                                 .skeleton_density = 0.1,
                                 .skin_width_nm = 400'000,
                                 .skeleton_width_nm = 600'000,
                                 .skin_depth_nm = 3'000'000,
                                 .lock_depth_nm = 1'000'000};
  const auto zones = LockedZones(BoxOf40(), {.angle_rad = 0.5, .layer = 7}, options);
  ASSERT_EQ(zones.size(), 2u);
  EXPECT_NEAR(Area(zones[0].area) / 1e12, 1600 - 34 * 34, 1e-3);
  EXPECT_NEAR(Area(zones[1].area) / 1e12, 36 * 36, 1e-3);
  EXPECT_NEAR(Area(Intersection(zones[0].area, zones[1].area)) / 1e12, 36 * 36 - 34 * 34, 1e-3);
  EXPECT_EQ(zones[0].fill.pattern, FillPattern::kCrossZag);
  EXPECT_EQ(zones[0].fill.density, 0.3);
  EXPECT_EQ(zones[0].fill.width_nm, 400'000);
  EXPECT_EQ(zones[0].fill.angle_rad, 0.5);
  EXPECT_EQ(zones[1].fill.pattern, FillPattern::kZigzag);
  EXPECT_EQ(zones[1].fill.density, 0.1);
  EXPECT_EQ(zones[1].fill.width_nm, 600'000);
  EXPECT_NEAR(zones[1].fill.angle_rad, 0.5 + std::numbers::pi / 2, 1e-12);
  EXPECT_EQ(zones[1].fill.layer, 7);
}

TEST(LockedZones, ANarrowRegionIsAllSkin) {
  const MultiPolygon narrow = MakePolygonsOrDie("(0 0, 40 0, 40 3, 0 3)");
  const auto zones = LockedZones(narrow, {}, {.skin_depth_nm = 2'000'000});
  ASSERT_EQ(zones.size(), 1u);
  EXPECT_EQ(zones[0].area, narrow);
}

TEST(LockedZones, TheSkeletonStaysInTheRegion) {
  const auto zones =
      LockedZones(BoxOf40(), {}, {.skin_depth_nm = 2'000'000, .lock_depth_nm = 5'000'000});
  ASSERT_EQ(zones.size(), 2u);
  EXPECT_NEAR(Area(zones[1].area) / 1e12, 1600, 1e-3);
}

}  // namespace
}  // namespace slicefarm::infill::locked_zag_test
