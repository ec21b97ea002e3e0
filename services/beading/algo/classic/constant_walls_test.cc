#include "services/beading/algo/classic/constant_walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::beading::constant_walls_test {
namespace {

constexpr Coord kHeight = 200'000;

WallPlan Plan(int perimeters) {
  WallPlan plan = WallPlan::Make(perimeters, 450'000, 450'000, kHeight);
  plan.gap_fill = plan.thin_walls = true;
  return plan;
}

PolygonWithHoles Island(std::string_view text) { return MakePolygonsOrDie(text)[0]; }
double Mm2(const MultiPolygon& polygons) { return Area(polygons) / 1e12; }

TEST(ConstantWalls, OfASquareLieAtTheirDistances) {
  const IslandWalls walls = MakeConstantWalls(Island("(0 0, 20 0, 20 20, 0 20)"), Plan(3));
  ASSERT_EQ(walls.centre_lines.size(), 3u);
  const double spacing = 0.407080;
  double side = 20 - 0.45;
  for (const MultiPolygon& centre : walls.centre_lines) {
    EXPECT_NEAR(Mm2(centre), side * side, 1e-4);
    side -= 2 * spacing;
  }
  side += spacing;
  EXPECT_NEAR(Mm2(walls.fill_area), side * side, 1e-4);
  EXPECT_TRUE(walls.gaps.empty());
}

TEST(ConstantWalls, WithoutPerimetersAllIsFillArea) {
  const PolygonWithHoles island = Island("(0 0, 20 0, 20 20, 0 20) (5 5, 6 5, 6 6, 5 6)");
  const IslandWalls walls = MakeConstantWalls(island, Plan(0));
  EXPECT_TRUE(walls.centre_lines.empty());
  EXPECT_EQ(walls.fill_area, MultiPolygon{island});
}

struct SlotCase {
  std::string name;
  double thickness_mm;
  size_t walls;  // number of insets with a ring
  size_t gaps;
  bool fill;
};
class Blade : public testing::TestWithParam<SlotCase> {};

TEST_P(Blade, HasTheseWalls) {
  const Coord t = FromMm(GetParam().thickness_mm);
  const PolygonWithHoles island{{{0, 0}, {30'000'000, 0}, {30'000'000, t}, {0, t}}, {}};
  const IslandWalls walls = MakeConstantWalls(island, Plan(3));
  size_t rings = 0;
  for (const MultiPolygon& centre : walls.centre_lines) rings += !centre.empty();
  EXPECT_EQ(rings, GetParam().walls);
  constexpr double kSliverNm2 = 30e6 * 70e3;
  size_t gaps = 0;
  for (const Gap& gap : walls.gaps) gaps += Area(gap.region) > kSliverNm2;
  EXPECT_EQ(gaps, GetParam().gaps);
  EXPECT_EQ(Area(walls.fill_area) > kSliverNm2, GetParam().fill);
}

INSTANTIATE_TEST_SUITE_P(ConstantWalls, Blade,
                         testing::Values(SlotCase{"ThinnerThanABead", 0.3, 0, 1, false},
                                         SlotCase{"OneBead", 0.45, 0, 1, false},
                                         SlotCase{"OneWideBead", 0.75, 0, 1, false},
                                         SlotCase{"TwoBeads", 0.86, 1, 0, false},
                                         SlotCase{"TwoBeadsAndAGap", 1.2, 1, 1, false},
                                         SlotCase{"FourBeads", 1.68, 2, 0, false},
                                         SlotCase{"SixBeads", 2.49, 3, 0, false},
                                         SlotCase{"SixBeadsAndInfill", 3.0, 3, 0, true},
                                         SlotCase{"SixBeadsAndMoreInfill", 5.0, 3, 0, true}),
                         [](const auto& info) { return info.param.name; });

// Rectangles of walls, gaps and fill area tile the island, except for the stripe along the outline
// and the corners.
TEST(ConstantWalls, VolumeIsConserved) {
  const std::pair<const char*, double> cases[] = {
      // With right angles, the error is a square of the stripe's width, times the number of convex
      // corners minus reflex corners.
      {"(0 0, 20 0, 20 20, 0 20)", 0.002},
      {"(0 0, 20 0, 20 20, 0 20) (3 3, 17 3, 17 17, 3 17)", 0.002},
      {"(0 0, 20 0, 20 3, 3 3, 3 20, 0 20)", 0.002},
      {"(0 0, 30 0, 30 1.1, 0 1.1)", 0.002},
      // Walls end along the slope.
      {"(0 0, 30 0, 30 5, 0 1.5)", 0.025},
  };
  for (const auto& [text, tolerance_mm2] : cases) {
    const PolygonWithHoles island = Island(text);
    const IslandWalls walls = MakeConstantWalls(island, Plan(3));
    double sum = Mm2(walls.fill_area);
    for (const Gap& gap : walls.gaps) sum += Area(gap.region) / 1e12;
    double perimeter = 0;
    for (const MultiPolygon& centre : walls.centre_lines)
      for (const Polygon& ring : Rings(centre)) sum += Perimeter(ring) / 1e6 * 0.407080;
    for (const Polygon& ring : Rings({island})) perimeter += Perimeter(ring) / 1e6;
    EXPECT_NEAR(sum, Area(island) / 1e12 - perimeter * 0.02146, tolerance_mm2) << text;
  }
}

TEST(ConstantWalls, NothingLeavesTheIsland) {
  const PolygonWithHoles island =
      Island("(0 0, 20 0, 20.3 4, 9 4.5, 10 18, 8.5 18, 8 5, 2 6) (4 1.2, 16 1.2, 16 2.4, 4 2.4)");
  const IslandWalls walls = MakeConstantWalls(island, Plan(3));
  for (const MultiPolygon& centre : walls.centre_lines)
    EXPECT_LT(Mm2(Difference(centre, {island})), 1e-6);
  for (const Gap& gap : walls.gaps) EXPECT_LT(Mm2(Difference({gap.region}, {island})), 1e-6);
  EXPECT_LT(Mm2(Difference(walls.fill_area, {island})), 1e-6);
}

TEST(NarrowParts, ANeckIsOneAndItsEndsAreNot) {
  const PolygonWithHoles area =
      Island("(0 0, 5 0, 5 2.3, 9 2.3, 9 0, 14 0, 14 5, 9 5, 9 2.7, 5 2.7, 5 5, 0 5)");
  const NarrowParts narrow = FindNarrowParts(area, 800'000);
  EXPECT_FALSE(narrow.are_all);
  double most = 0;  // corners give slivers
  for (const PolygonWithHoles& part : narrow.parts) most = std::max(most, Area(part) / 1e12);
  EXPECT_NEAR(most, 4 * 0.4, 0.1);
  EXPECT_NEAR(Mm2(narrow.parts), 4 * 0.4, 0.1);
  EXPECT_LT(Mm2(Difference(narrow.parts, {area})), 1e-6);
}

TEST(NarrowParts, AWideAreaHasNone) {
  EXPECT_TRUE(FindNarrowParts(Island("(0 0, 9 0, 9 9, 0 9)"), 800'000).parts.empty());
}

// The neck of 1.6 mm2 is the only narrow part; a tip has 0.4 mm2.
TEST(NarrowParts, SmallOnesCanBeLeftOut) {
  const PolygonWithHoles neck =
      Island("(0 0, 5 0, 5 2.3, 9 2.3, 9 0, 14 0, 14 5, 9 5, 9 2.7, 5 2.7, 5 5, 0 5)");
  EXPECT_FALSE(FindNarrowParts(neck, 800'000, 1e12).parts.empty());
  const PolygonWithHoles loop =
      Island("(0 0, 9 0, 9 0.5, 5 0.5, 5 5, 0 5) (0.3 0.3, 0.3 1, 1 1, 1 0.3)");
  EXPECT_FALSE(FindNarrowParts(loop, 800'000, 1e12).parts.empty());
  const PolygonWithHoles finger = Island("(0 0, 5 0, 5 2.3, 9 2.3, 9 2.7, 5 2.7, 5 5, 0 5)");
  EXPECT_FALSE(FindNarrowParts(finger, 800'000, 1e12).parts.empty());
  const PolygonWithHoles tip = Island("(0 0, 5 0, 5 2.3, 6 2.3, 6 2.7, 5 2.7, 5 5, 0 5)");
  EXPECT_FALSE(FindNarrowParts(tip, 800'000).parts.empty());
  EXPECT_TRUE(FindNarrowParts(tip, 800'000, 1e12).parts.empty());
}

TEST(NarrowParts, AStripIsOne) {
  const PolygonWithHoles strip = Island("(0 0, 9 0, 9 0.7, 0 0.7)");
  const NarrowParts narrow = FindNarrowParts(strip, 800'000);
  EXPECT_TRUE(narrow.are_all);
  EXPECT_EQ(narrow.parts, MultiPolygon{strip});
}

TEST(ConstantWalls, FirstWidthAloneIsExternal) {
  WallPlan plan = WallPlan::Make(2, 600'000, 400'000, kHeight);
  const IslandWalls walls = MakeConstantWalls(Island("(0 0, 20 0, 20 20, 0 20)"), plan);
  ASSERT_EQ(walls.centre_lines.size(), 2u);
  EXPECT_NEAR(Mm2(walls.centre_lines[0]), 19.4 * 19.4, 1e-4);
  const double second = 20 - 2 * (0.3 + (0.557080 + 0.357080) / 2);
  EXPECT_NEAR(Mm2(walls.centre_lines[1]), second * second, 1e-3);
}

TEST(ConstantWalls, TheOutermostMayStandApart) {
  WallPlan plan = Plan(3);
  plan.apart_nm = 50'000;
  const IslandWalls walls = MakeConstantWalls(Island("(0 0, 20 0, 20 20, 0 20)"), plan);
  ASSERT_EQ(walls.centre_lines.size(), 3u);
  const double spacing = 0.407080;
  const double outer = 20 - 0.45, second = outer - 2 * (spacing + 0.05);
  EXPECT_NEAR(Mm2(walls.centre_lines[0]), outer * outer, 1e-3);
  EXPECT_NEAR(Mm2(walls.centre_lines[1]), second * second, 1e-3);
  const double third = second - 2 * spacing;
  EXPECT_NEAR(Mm2(walls.centre_lines[2]), third * third, 1e-3);
  plan.perimeters = 1;
  const double inside = outer - spacing;
  EXPECT_NEAR(Mm2(MakeConstantWalls(Island("(0 0, 20 0, 20 20, 0 20)"), plan).fill_area),
              inside * inside, 1e-3);
}

}  // namespace
}  // namespace slicefarm::beading::constant_walls_test
