#include "services/beading/algo/extra_walls.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"

namespace slicefarm::beading::extra_walls_test {
namespace {

/// Returns a plan of walls that are about 0.41 mm apart.
WallPlan Plan(int perimeters) { return WallPlan::Make(perimeters, 450'000, 450'000, 200'000); }

PolygonWithHoles Island() { return MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20)")[0]; }

MultiPolygon Square(double inset_mm) {
  const Coord from = FromMm(inset_mm), to = FromMm(20 - inset_mm);
  return {{{{from, from}, {to, from}, {to, to}, {from, to}}, {}}};
}

TEST(ExtraWalls, NoneInUprightAndOverhangingWalls) {
  EXPECT_EQ(ExtraWalls(Island(), Square(0), Plan(2)), 0);
  EXPECT_EQ(ExtraWalls(Island(), Square(-1), Plan(2)), 0);
  EXPECT_EQ(ExtraWalls(Island(), {}, Plan(2)), 0) << "air";
}

TEST(ExtraWalls, AsManyAsTheWallsAboveNeed) {
  // Two walls are 0.84 mm thick. Outlines over these walls need no extra wall; outlines far inside
  // need none either.
  EXPECT_EQ(ExtraWalls(Island(), Square(0.5), Plan(2)), 0);
  EXPECT_GE(ExtraWalls(Island(), Square(1.0), Plan(2)), 1);
  EXPECT_EQ(ExtraWalls(Island(), Square(1.0), Plan(3)), 0);
  EXPECT_EQ(ExtraWalls(Island(), Square(4.0), Plan(2)), 0) << "a step, no slope";
  EXPECT_EQ(ExtraWalls(Island(), Square(1.0), Plan(0)), 0);
}

TEST(ExtraWalls, NoneForALittleOfTheOutline) {
  // A side of 20 mm has a notch of 2 mm.
  const MultiPolygon notched = MakePolygonsOrDie("(0 0, 9 0, 9 1, 11 1, 11 0, 20 0, 20 20, 0 20)");
  EXPECT_EQ(ExtraWalls(Island(), notched, Plan(2)), 0);
}

}  // namespace
}  // namespace slicefarm::beading::extra_walls_test
