#include "services/planning/algo/supports/generator/bridges.h"

#include <gtest/gtest.h>

#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::bridges_test {
namespace {

struct Case {
  std::string name;
  MultiPolygon above;
  MultiPolygon below;
  double bridged;  ///< share of the overhang that is bridged
};

class BridgesTest : public testing::TestWithParam<Case> {};

TEST_P(BridgesTest, CoversThisMuch) {
  const MultiPolygon hanging = Difference(GetParam().above, GetParam().below);
  const MultiPolygon bridges = BridgesOf(hanging, hanging, GetParam().below, {450'000, 1'350'000});
  EXPECT_NEAR(AreaMm2(Intersection(bridges, hanging)) / AreaMm2(hanging), GetParam().bridged, 0.05);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, BridgesTest,
    testing::Values(
        Case{"Gate", BoxOf(0, 0, 14, 10), Union(BoxOf(0, 0, 2, 10), BoxOf(12, 0, 14, 10)), 1},
        Case{"LeaningGate", MakePolygonsOrDie("(0 0, 10 5, 6 13, -4 8)"),
             MakePolygonsOrDie("(0 0, 2 1, -2 9, -4 8); (8 4, 10 5, 6 13, 4 12)"), 1},
        Case{"Shelf", BoxOf(0, 0, 10, 10), BoxOf(0, 0, 5, 10), 0},
        Case{"Roof", BoxOf(-3, -3, 13, 13), BoxOf(0, 0, 10, 10), 0},
        Case{"Hole", BoxOf(0, 0, 10, 10), Difference(BoxOf(0, 0, 10, 10), BoxOf(3, 3, 7, 7)), 1},
        // Lines between the front and rear legs, or between the left and right legs, and walls.
        Case{"FourLegs", BoxOf(0, 0, 20, 20),
             Union(Union(BoxOf(0, 0, 4, 4), BoxOf(16, 0, 20, 4)),
                   Union(BoxOf(0, 16, 4, 20), BoxOf(16, 16, 20, 20))),
             (2 * 12 * 4 + 2 * 12 * 1.35) / 336},
        Case{"CornerOfAWall", BoxOf(0, 0, 10, 10), Union(BoxOf(0, 0, 10, 2), BoxOf(0, 0, 2, 10)),
             6.65 * 6.65 / 2 / 64},
        Case{"Beam", BoxOf(0, 0, 14, 2), Union(BoxOf(0, 0, 2, 2), BoxOf(12, 0, 14, 2)), 1},
        // The walls around the hole turn in the air, so lines that end on them have no anchor.
        Case{"HoleInARoof", Difference(BoxOf(0, 0, 20, 20), BoxOf(8, 8, 12, 12)),
             Difference(BoxOf(0, 0, 20, 20), BoxOf(2, 2, 18, 18)),
             1 - (16 * 6.7 - 16) / (256. - 16)},
        // Bars between slots, as wide as their walls, with a frame around them.
        Case{"Grating",
             Difference(BoxOf(0, 0, 30, 30), Union(Union(BoxOf(6, 6, 10, 24), BoxOf(12, 6, 16, 24)),
                                                   BoxOf(18, 6, 24, 24))),
             Difference(BoxOf(0, 0, 30, 30), BoxOf(1, 1, 29, 29)),
             2 * 28 * (6 - 1 - 1.35) / (28. * 28 - 14 * 18)}),
    [](const auto& info) { return info.param.name; });

TEST(BridgesOf, LooksOnlyWhereSomethingIsSteep) {
  const MultiPolygon below = Union(BoxOf(0, 0, 2, 10), BoxOf(12, 0, 14, 10));
  const MultiPolygon hanging = Difference(BoxOf(0, 0, 14, 10), below);
  EXPECT_TRUE(BridgesOf(hanging, BoxOf(50, 50, 51, 51), below, {450'000, 1'350'000}).empty());
}

}  // namespace
}  // namespace slicefarm::planning::bridges_test
