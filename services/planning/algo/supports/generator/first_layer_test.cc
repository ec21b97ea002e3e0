#include "services/planning/algo/supports/generator/first_layer.h"

#include <gtest/gtest.h>

#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::first_layer_test {
namespace {

constexpr Coord kWidthNm = 400'000;

/// Returns a layer on the bed with a branch of 4 x 4 mm around the origin.
SupportLayer Branch() {
  return {200'000, 200'000, true, {{SupportRole::kBranch, BoxOf(-2, -2, 2, 2)}}};
}

MultiPolygon Grown(double by_mm, const SupportProblem& problem, SupportLayer layer = Branch()) {
  const SupportOptions options;
  const Clearance clearance(problem, options, 10'000'000, 1);
  GrowFirstLayer(FromMm(by_mm), kWidthNm, clearance, layer);
  MultiPolygon all;
  for (const SupportRegion& region : layer.regions) all = Union(all, region.outlines);
  return all;
}

const TestStack kNothing(5, [](double) { return MultiPolygon(); });

TEST(GrowFirstLayer, GrowsByWhatIsAskedFor) {
  for (const double by : {0.0, 0.3, 1.0, 3.0}) {
    const Box box = Bounds(Grown(by, kNothing.Problem()));
    EXPECT_EQ(box.min, (Point{FromMm(-2 - by), FromMm(-2 - by)})) << by;
    EXPECT_EQ(box.max, (Point{FromMm(2 + by), FromMm(2 + by)})) << by;
  }
}

TEST(GrowFirstLayer, KeepsItsDistanceFromThePart) {
  const TestStack wall(5, [](double) { return BoxOf(3, -20, 9, 20); });
  const Box box = Bounds(Grown(3, wall.Problem()));
  EXPECT_NEAR(ToMm(box.max.x), 3 - 0.225, 1e-3);
  EXPECT_NEAR(ToMm(box.min.x), -5, 1e-6);
}

TEST(GrowFirstLayer, DoesNotLeakThroughThinWalls) {
  const TestStack wall(5, [](double) { return BoxOf(3, -20, 3.4, 20); });
  EXPECT_LE(ToMm(Bounds(Grown(8, wall.Problem())).max.x), 3);
}

TEST(GrowFirstLayer, GoesRoundCorners) {
  const TestStack post(5, [](double) { return BoxOf(3, -1, 4, 1); });
  const MultiPolygon grown = Grown(6, post.Problem());
  EXPECT_GT(ToMm(Bounds(grown).max.x), 7);
  EXPECT_LT(AreaMm2(Intersection(grown, BoxOf(3, -1, 4, 1))), 1e-9);
}

TEST(GrowFirstLayer, StaysOnTheBed) {
  SupportProblem problem = kNothing.Problem();
  problem.bed = BoxOf(-3, -30, 30, 30);
  EXPECT_EQ(Bounds(Grown(3, problem)).min.x, FromMm(-3));
}

TEST(GrowFirstLayer, LeavesInterfacesAsTheyAre) {
  SupportLayer layer = Branch();
  layer.regions.push_back({SupportRole::kTopInterface, BoxOf(2, -1, 4, 1)});
  const SupportProblem problem = kNothing.Problem();
  const SupportOptions options;
  const Clearance clearance(problem, options, 10'000'000, 1);
  GrowFirstLayer(FromMm(3), kWidthNm, clearance, layer);
  ASSERT_EQ(layer.regions.size(), 2u);
  EXPECT_EQ(layer.regions[1].outlines, BoxOf(2, -1, 4, 1));
  EXPECT_EQ(AreaMm2(Intersection(layer.regions[0].outlines, layer.regions[1].outlines)), 0);
}

}  // namespace
}  // namespace slicefarm::planning::first_layer_test
