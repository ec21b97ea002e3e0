#include "services/beading/algo/classic/classic_island.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::beading::classic_island_test {
namespace {

constexpr Coord kHeight = 200'000;
/// Difference between the width of beads side by side and their distance.
constexpr double kOverlapMm = 0.2 * (1 - 3.14159265358979 / 4);

WallPlan Plan(int perimeters, Coord external_width_nm = 450'000, Coord inner_width_nm = 450'000) {
  WallPlan plan = WallPlan::Make(perimeters, external_width_nm, inner_width_nm, kHeight);
  plan.gap_fill = plan.thin_walls = true;
  return plan;
}

IslandBeads IslandOf(std::string_view outline, const WallPlan& plan) {
  auto island = MakeClassicIsland(MakePolygonsOrDie(outline)[0], plan, {}, {});
  EXPECT_TRUE(island.ok()) << island.status();
  return island.ok() ? *std::move(island) : IslandBeads{};
}

double Mm2(const MultiPolygon& polygons) { return Area(polygons) / 1e12; }

constexpr std::string_view kSquare = "(0 0, 20 0, 20 20, 0 20)";

TEST(ClassicIsland, WallsHaveTheWidthsAndTheFillAreaWhatTheyLeave) {
  const IslandBeads island = IslandOf(kSquare, Plan(3, 600'000, 400'000));
  ASSERT_EQ(island.walls.size(), 3u);
  for (int inset = 0; inset < 3; ++inset) {
    const Path& wall = island.walls[inset];
    EXPECT_EQ(wall.inset, inset);
    EXPECT_EQ(wall.feature, inset == 0 ? Feature::kExternalPerimeter : Feature::kPerimeter);
    EXPECT_TRUE(wall.closed);
    EXPECT_EQ(wall.widths_nm, std::vector<Coord>{inset == 0 ? 600'000 : 400'000});
    EXPECT_EQ(wall.points.size(), 4u);
  }
  // The outer bead counts with its full width, the inner two with their distance.
  const double side = 20 - 2 * (0.6 + 2 * 0.4 - 2.5 * kOverlapMm);
  EXPECT_NEAR(Mm2(island.fill_area), side * side, 1e-4);
}

TEST(ClassicIsland, HolesHaveWallsToo) {
  const IslandBeads island = IslandOf("(0 0, 20 0, 20 20, 0 20) (8 8, 12 8, 12 12, 8 12)", Plan(2));
  ASSERT_EQ(island.walls.size(), 4u);
  int external = 0, around_the_hole = 0;
  for (const Path& wall : island.walls) {
    external += wall.feature == Feature::kExternalPerimeter;
    around_the_hole += SignedArea(wall.points) < 0;
  }
  EXPECT_EQ(external, 2);
  EXPECT_EQ(around_the_hole, 2);
}

TEST(ClassicIsland, WithoutPerimetersAllIsFillArea) {
  const IslandBeads island = IslandOf(kSquare, Plan(0));
  EXPECT_TRUE(island.walls.empty());
  EXPECT_EQ(island.fill_area, MakePolygonsOrDie(kSquare));
}

TEST(ClassicIsland, WhatIsTooThinForWallsIsAGap) {
  const IslandBeads island = IslandOf("(0 0, 20 0, 20 0.4, 0 0.4)", Plan(3));
  ASSERT_EQ(island.walls.size(), 1u);
  EXPECT_EQ(island.walls[0].feature, Feature::kGapFill);
  EXPECT_EQ(island.walls[0].widths_nm, std::vector<Coord>{400'000});
  EXPECT_TRUE(island.fill_area.empty());
}

constexpr std::string_view kWallAndGap = "(0 0, 20 0, 20 1.2, 0 1.2)";

// The bead gets 1.2 mm minus two walls of 0.45 mm, plus its overlap with the wall on either side.
TEST(ClassicIsland, AGapBetweenWallsIsFilled) {
  const IslandBeads island = IslandOf(kWallAndGap, Plan(3));
  ASSERT_EQ(island.walls.size(), 2u);
  EXPECT_EQ(island.walls[0].feature, Feature::kExternalPerimeter);
  EXPECT_EQ(island.walls[1].feature, Feature::kGapFill);
  ASSERT_EQ(island.walls[1].widths_nm.size(), 1u);
  EXPECT_NEAR(island.walls[1].widths_nm[0], FromMm(0.3 + 2 * kOverlapMm), 1'000);
  for (const Point p : island.walls[1].points) EXPECT_NEAR(p.y, 600'000, 1);
}

TEST(ClassicIsland, GapsStayEmptyIfTheyAreTo) {
  WallPlan plan = Plan(3);
  plan.gap_fill = plan.thin_walls = false;
  EXPECT_EQ(IslandOf(kWallAndGap, plan).walls.size(), 1u);
  EXPECT_TRUE(IslandOf("(0 0, 20 0, 20 0.4, 0 0.4)", plan).walls.empty());
}

// The outline has a tooth of 55 degrees, cut off where it is 0.3 mm wide.
TEST(ClassicIsland, TheWallGoesRoundATooth) {
  const IslandBeads island =
      IslandOf("(0 0, 20 0, 20 10, 11.35 10, 10.15 12.305, 9.85 12.305, 8.65 10, 0 10)", Plan(1));
  ASSERT_EQ(island.walls.size(), 1u);
  EXPECT_EQ(island.walls[0].feature, Feature::kExternalPerimeter);
  Coord top = 0;
  for (const Point p : island.walls[0].points) top = std::max(top, p.y);
  EXPECT_GT(top, FromMm(12.05));
}

// The outline is a square with a spike 0.3 mm wide and a longer spike.
TEST(ClassicIsland, ShortTipsOfAWallMayStayOut) {
  constexpr std::string_view kSpikes =
      "(0 0, 20 0, 20 5, 20.8 5, 20.8 5.3, 20 5.3, 20 10, 24 10, 24 10.3, 20 10.3, 20 20, 0 20)";
  const auto beads_beside_walls = [](std::string_view outline, Coord least_tip_nm) {
    WallPlan plan = Plan(1);
    plan.gap_fill = false;
    plan.least_tip_nm = least_tip_nm;
    const IslandBeads island = IslandOf(outline, plan);
    return std::ranges::count(island.walls, false, &Path::closed);
  };
  EXPECT_EQ(beads_beside_walls(kSpikes, 0), 2);
  EXPECT_EQ(beads_beside_walls(kSpikes, 1'500'000), 1);
  EXPECT_EQ(beads_beside_walls("(0 0, 1 0, 1 0.3, 0 0.3)", 1'500'000), 1) << "all there is";
}

// A width of 0.6 mm is enough for one wall of 0.45 mm, not for two.
TEST(ClassicIsland, WithoutThinWallsALoopOverlapsItself) {
  WallPlan plan = Plan(3);
  plan.thin_walls = false;
  const IslandBeads island = IslandOf("(0 0, 20 0, 20 0.6, 0 0.6)", plan);
  ASSERT_EQ(island.walls.size(), 1u);
  EXPECT_EQ(island.walls[0].feature, Feature::kExternalPerimeter);
  EXPECT_TRUE(island.walls[0].closed);
  for (const Point p : island.walls[0].points)
    EXPECT_NEAR(std::min(p.y, 600'000 - p.y), 225'000, 1);
}

TEST(ClassicIsland, StopsWhenCancelled) {
  const auto island = MakeClassicIsland(MakePolygonsOrDie(kWallAndGap)[0], Plan(3), {},
                                        CancelToken([] { return true; }));
  EXPECT_TRUE(absl::IsCancelled(island.status()));
}

}  // namespace
}  // namespace slicefarm::beading::classic_island_test
