#include "services/planning/algo/supports/generator/bridge_walls.h"

#include <gtest/gtest.h>

#include <string>

#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::bridge_walls_test {
namespace {

struct Case {
  std::string name;
  MultiPolygon above;
  MultiPolygon below;
  double area_mm2;  ///< area of walls 1 mm thick
  double held_mm2;
};

class WallsOfTest : public testing::TestWithParam<Case> {};

TEST_P(WallsOfTest, AreaAndWhatHolds) {
  double area = 0, held = 0;
  for (const PolygonWithHoles& part : Difference(GetParam().above, GetParam().below)) {
    const BridgeWalls walls = WallsOf(part, GetParam().below, 1'000'000);
    area += AreaMm2(walls.area);
    held += AreaMm2(walls.held);
    EXPECT_LT(AreaMm2(Difference(walls.held, walls.area)), 1e-6);
    EXPECT_LT(AreaMm2(Difference(walls.area, {part})), 1e-6);
  }
  EXPECT_NEAR(area, GetParam().area_mm2, 0.02 * GetParam().area_mm2 + 1e-6);
  EXPECT_NEAR(held, GetParam().held_mm2, 0.02 * GetParam().held_mm2 + 1e-6);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, WallsOfTest,
    testing::Values(
        Case{"Gate", BoxOf(0, 0, 14, 10), Union(BoxOf(0, 0, 2, 10), BoxOf(12, 0, 14, 10)), 20, 20},
        Case{"TurnedGate", MakePolygonsOrDie("(0 0, 10 5, 6 13, -4 8)"),
             MakePolygonsOrDie("(0 0, 2 1, -2 9, -4 8); (8 4, 10 5, 6 13, 4 12)"), 13.42, 13.42},
        Case{"Shelf", BoxOf(0, 0, 10, 10), BoxOf(0, 0, 5, 10), 5 + 5 + 10 - 2, 0},
        Case{"Tongue", BoxOf(0, 0, 10, 1.5), BoxOf(0, 0, 5, 1.5), 7.5, 0},
        Case{"PocketInASolid", BoxOf(0, 0, 10, 10),
             Difference(BoxOf(0, 0, 10, 10), BoxOf(3, 3, 7, 7)), 0, 0},
        Case{"HoleOverAPocket", Difference(BoxOf(0, 0, 20, 20), BoxOf(8, 8, 12, 12)),
             Difference(BoxOf(0, 0, 20, 20), BoxOf(2, 2, 18, 18)), 6 * 6 - 4 * 4, 0},
        // The edge of this part bends between the posts.
        Case{"Bow", MakePolygonsOrDie("(0 0, 10 1, 20 0, 20 4, 0 4)"),
             Union(BoxOf(0, 0, 2, 4), BoxOf(18, 0, 20, 4)), 32, 16}),
    [](const auto& info) { return info.param.name; });

TEST(WallsOf, NoneIfThereAreNone) {
  const MultiPolygon part = BoxOf(2, 0, 12, 10);
  EXPECT_TRUE(WallsOf(part[0], Union(BoxOf(0, 0, 2, 10), BoxOf(12, 0, 14, 10)), 0).area.empty());
}

}  // namespace
}  // namespace slicefarm::planning::bridge_walls_test
