#include "services/planning/algo/infill/sparse_areas.h"

#include <gtest/gtest.h>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "services/planning/algo/infill/stacks_test.h"

namespace slicefarm::planning::sparse_areas_test {
namespace {

double Mm2(const MultiPolygon& region) { return Area(region) * 1e-12; }

TEST(SparseAreas, LieInsideOfWallsAndSkins) {
  // A plate of 20 mm with a tower of 10 mm on one half.
  const ObjectStack stack = StackOf(20, [](int i) {
    return MakePolygonsOrDie(i < 10 ? "(0 0, 20 0, 20 10, 0 10)" : "(0 0, 10 0, 10 10, 0 10)");
  });
  const auto areas = SparseAreas(stack, InnerAreas(stack, 1'000'000), {3, 2});
  for (const int i : {0, 1, 17, 18, 19}) EXPECT_TRUE(areas[static_cast<size_t>(i)].empty()) << i;
  for (const int i : {2, 6}) EXPECT_NEAR(Mm2(areas[static_cast<size_t>(i)]), 18 * 8, 1e-6) << i;
  for (const int i : {7, 9}) EXPECT_NEAR(Mm2(areas[static_cast<size_t>(i)]), 9 * 8, 1e-6) << i;
  for (const int i : {10, 16}) EXPECT_NEAR(Mm2(areas[static_cast<size_t>(i)]), 8 * 8, 1e-6) << i;
  const auto roofs = RoofsOf(areas);
  for (const int i : {0, 2, 5, 10, 15}) EXPECT_TRUE(roofs[static_cast<size_t>(i)].empty()) << i;
  EXPECT_NEAR(Mm2(roofs[6]), 9 * 8, 1e-6);
  EXPECT_NEAR(Mm2(roofs[16]), 8 * 8, 1e-6);
}

TEST(SparseAreas, LayersThatOnlyThicknessAsksForAreLeftOutByTheirHeights) {
  ObjectStack stack = Prism(10, "(0 0, 20 0, 20 10, 0 10)");
  for (StackLayer& layer : stack) layer.height_nm = 200'000;
  stack[0].height_nm = 300'000;
  const ShellExtra spare{.layers = 2, .enough_nm = 700'000};
  const auto areas = SparseAreas(
      stack, InnerAreas(stack, 1'000'000),
      {.top_solid_layers = 4, .bottom_solid_layers = 4, .top_spare = spare, .bottom_spare = spare});
  for (size_t i = 0; i < stack.size(); ++i) EXPECT_EQ(areas[i].empty(), i < 3 || i > 5) << i;
}

// A prism of which the right half is another region from layer 5 up.
TEST(SparseAreas, OfARegionAloneEndBelowOtherRegions) {
  ObjectStack stack = Prism(10, "(0 0, 20 0, 20 10, 0 10)");
  for (size_t i = 5; i < 10; ++i) stack[i].region = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)");
  for (const bool alone : {false, true}) {
    const auto areas =
        SparseAreas(stack, InnerAreas(stack, 1'000'000),
                    {.top_solid_layers = 2, .bottom_solid_layers = 1, .of_region_alone = alone});
    EXPECT_NEAR(Mm2(areas[2]), 18 * 8, 1e-6);
    EXPECT_NEAR(Mm2(areas[4]), (alone ? 9 : 18) * 8, 1e-6);
    EXPECT_NEAR(Mm2(areas[6]), 8 * 8, 1e-6);
  }
}

TEST(SparseAreas, WithoutSkinsAllInsideOfTheWalls) {
  const ObjectStack stack = Prism(3, "(0 0, 20 0, 20 10, 0 10)");
  const auto areas = SparseAreas(stack, InnerAreas(stack, 1'000'000), {0, 0});
  for (const MultiPolygon& area : areas) EXPECT_NEAR(Mm2(area), 18 * 8, 1e-6);
  EXPECT_TRUE(SparseAreas({}, {}, {}).empty());
}

// Strips of a slope do not count as support until they have the requested width.
TEST(HollowAreas, TakeInNarrowSolidInfill) {
  const ObjectStack stack = StackOf(30, [](int i) {
    const MultiPolygon plate = MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20)");
    return i < 20 ? plate : MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20) (8 8, 8 12, 10 12, 10 8)");
  });
  const auto areas = SparseAreas(stack, InnerAreas(stack, FromMm(1)), {3, 3});
  for (const double least_mm : {1.5, 3.0}) {
    const auto hollow = HollowAreas(InnerAreas(stack, FromMm(1)), areas, FromMm(least_mm));
    ASSERT_EQ(hollow.size(), areas.size());
    // Below the opening, which is 2 mm wide.
    EXPECT_NEAR(Area(areas[18]) / 1e12, 18 * 18 - 8, 1e-3);
    EXPECT_NEAR(Area(hollow[18]) / 1e12, 18 * 18 - (least_mm < 2 ? 8 : 0), 0.5) << least_mm;
    EXPECT_EQ(hollow[10], areas[10]);
    EXPECT_TRUE(hollow[0].empty());
  }
}

}  // namespace
}  // namespace slicefarm::planning::sparse_areas_test
