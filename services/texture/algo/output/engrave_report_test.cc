#include "services/texture/algo/output/engrave_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/texture/algo/paths/sample_maps_test.h"
#include "services/texture/algo/pattern/computed_heights.h"

namespace slicefarm::texture::engrave_report_test {
namespace {

EngravePlan PlanOn(const SurfaceMesh& mesh, bool equidistant) {
  return *PlanEngraving(
      FlatMapOf(mesh),
      *TextureOf(*ComputedHeights(*ParseTextureSpec("bumps:height=0.02,pitch=0.2"))), std::nullopt,
      {.lines = {{0.05, 0}}, .equidistant = equidistant});
}

TEST(SpreadOf, CountsWeights) {
  const Spread spread = SpreadOf({3, 1, 2}, {1, 98, 1});
  EXPECT_EQ(spread.p1, 1);
  EXPECT_EQ(spread.p50, 1);
  EXPECT_EQ(spread.p99, 2);
}

TEST(MapReport, OfACylinderHasNoDistortion) {
  const auto report = MapReportOf(PlanOn(HalfCylinder(10, 5, 12), false));
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(report->faces, 200);
  EXPECT_NEAR(report->energy_mean, 1, 1e-4);
  EXPECT_NEAR(report->stretch.p1, 1, 1e-2);
  EXPECT_NEAR(report->stretch.p99, 1, 1e-2);
  EXPECT_NEAR(report->line_distance_mm.p50, 0.05, 1e-3);
  EXPECT_NEAR(report->line_even, 1, 1e-6);
  EXPECT_TRUE(WarningsOf(*report, {{.runs = 1}}).empty());
}

TEST(MapReport, OfACapTellsThatLinesAreUneven) {
  const auto straight = MapReportOf(PlanOn(Cap(30, -0.7), false));
  const auto even = MapReportOf(PlanOn(Cap(30, -0.7), true));
  ASSERT_TRUE(straight.ok() && even.ok());
  EXPECT_LT(straight->line_even, 0.7);
  EXPECT_GT(even->line_even, 0.95);
  const std::vector<LayerNumbers> layers = {{.runs = 1}};
  EXPECT_THAT(WarningsOf(*straight, layers),
              testing::Contains(testing::HasSubstr("the surface was stretched")));
}

}  // namespace
}  // namespace slicefarm::texture::engrave_report_test
