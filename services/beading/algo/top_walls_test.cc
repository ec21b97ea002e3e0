#include "services/beading/algo/top_walls.h"

#include <gtest/gtest.h>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::beading::top_walls_test {
namespace {

double Mm2(const MultiPolygon& area) { return Area(area) * 1e-12; }

const WallPlan& Plan() {
  static const WallPlan plan = WallPlan::Make(3, 450'000, 450'000, 200'000);
  return plan;
}

struct TopCase {
  const char* name;
  const char* above;
  const char* below;  // null: the bed
  double top_mm2;
};

std::ostream& operator<<(std::ostream& out, const TopCase& c) { return out << c.name; }

class PartByTopTest : public testing::TestWithParam<TopCase> {};

TEST_P(PartByTopTest, TilesTheInside) {
  const MultiPolygon inside = MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20)");
  const MultiPolygon above = MakePolygonsOrDie(GetParam().above);
  MultiPolygon below;
  if (GetParam().below != nullptr) below = MakePolygonsOrDie(GetParam().below);
  const TopParts parts =
      PartByTop(inside, above, GetParam().below == nullptr ? nullptr : &below, Plan());
  EXPECT_NEAR(Mm2(parts.top), GetParam().top_mm2, 0.05);
  EXPECT_NEAR(Mm2(parts.top) + Mm2(parts.covered), 400, 1e-3);
  EXPECT_TRUE(Intersection(parts.top, parts.covered).empty());
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, PartByTopTest,
    testing::Values(
        TopCase{"Covered", "(-1 -1, 21 -1, 21 21, -1 21)", nullptr, 0},
        TopCase{"Air", "", nullptr, 400},
        TopCase{"Half", "(-1 -1, 10 -1, 10 21, -1 21)", nullptr, 200},
        TopCase{"SlopeOfATenthOfAWall", "(-1 -1, 19.955 -1, 19.955 21, -1 21)", nullptr, 0},
        TopCase{"OverAir", "(-1 -1, 10 -1, 10 21, -1 21)", "(-1 -1, 10 -1, 10 21, -1 21)", 0},
        TopCase{"PartlyOverAir", "(-1 -1, 10 -1, 10 21, -1 21)", "(-1 -1, 15 -1, 15 21, -1 21)",
                91}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(MakeInner, LeavesGapFillAlone) {
  std::vector<Path> walls(2);
  walls[0].feature = Feature::kExternalPerimeter;
  walls[0].inset = 0;
  walls[1].feature = Feature::kGapFill;
  MakeInner(walls);
  EXPECT_EQ(walls[0].feature, Feature::kPerimeter);
  EXPECT_EQ(walls[0].inset, 1);
  EXPECT_EQ(walls[1].feature, Feature::kGapFill);
  EXPECT_EQ(walls[1].inset, Path().inset);
}

TEST(PartByTop, NarrowTopSurfacesKeepTheirWallsIfAskedFor) {
  const MultiPolygon inside = MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20)");
  const MultiPolygon above = MakePolygonsOrDie("(-1 -1, 19 -1, 19 21, -1 21)");
  WallPlan plan = Plan();
  EXPECT_NEAR(Mm2(PartByTop(inside, above, nullptr, plan).top), 20, 0.5);
  plan.min_top_nm = 1'350'000;
  EXPECT_TRUE(PartByTop(inside, above, nullptr, plan).top.empty());
  plan.min_top_nm = 900'000;
  EXPECT_NEAR(Mm2(PartByTop(inside, above, nullptr, plan).top), 20, 0.5);
}

}  // namespace
}  // namespace slicefarm::beading::top_walls_test
