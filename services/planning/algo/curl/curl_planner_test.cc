#include "services/planning/algo/curl/curl_planner.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/geometry/text_format_test.h"
#include "common/model/options/planning_options.h"
#include "services/planning/algo/job_planner.h"
#include "services/planning/algo/layers_test.h"

namespace slicefarm::planning::curl_planner_test {
namespace {

constexpr std::string_view kLow = "(-5 -5, 5 -5, 5 5, -5 5)";
constexpr std::string_view kHigh = "(-5.3 -5.3, 5.3 -5.3, 5.3 5.3, -5.3 5.3)";

PlanningOptions Options(bool avoid_curled = true) {
  PlanningOptions options;
  options.objects[0].support.wall_width_nm = 450'000;
  options.avoid_curled = avoid_curled;
  return options;
}

/// Returns the curled regions by layer.
std::vector<MultiPolygon> Curled(const PlanningOptions& options) {
  const std::vector<PlacedCopy> copies = {{0, {}, {}}};
  auto planner = JobPlanner::Make(options, copies);
  EXPECT_TRUE(planner.ok()) << planner.status();
  for (const SlicedLayer& layer : LayersOrDie({kLow, kHigh, kHigh}))
    EXPECT_TRUE(planner->Next(layer).ok());
  const auto plan = planner->Finish();
  EXPECT_TRUE(plan.ok()) << plan.status();
  std::vector<MultiPolygon> areas;
  for (const LayerPlan& layer : plan->layers)
    for (const SectionPlan& section : layer.sections) areas.push_back(section.curled);
  return areas;
}

TEST(CurlPlanner, TellsOfCurledCorners) {
  const auto areas = Curled(Options());
  ASSERT_EQ(areas.size(), 3U);
  EXPECT_TRUE(areas[0].empty());
  EXPECT_EQ(areas[1].size(), 4U);
  EXPECT_EQ(areas[2].size(), 4U);
}

TEST(CurlPlanner, IsAskedFor) {
  // The plan may have no sections here, but it has them if curled regions are asked for.
  ASSERT_FALSE(Curled(Options(true)).empty());
  for (const MultiPolygon& area : Curled(Options(false))) EXPECT_TRUE(area.empty());
}

TEST(CurlPlanner, WhatSupportsCarryLiesStill) {
  const PlanningOptions options = Options();
  CurlPlanner planner(options);
  const std::vector<SlicedLayer> layers = LayersOrDie({kLow, kHigh});
  ASSERT_EQ(layers.size(), 2u);
  for (const SlicedLayer& layer : layers) {
    LayerPlan plan;
    PlanOf(0, plan).above_supports = MakePolygonsOrDie("(-9 -9, 9 -9, 9 9, -9 9)");
    planner.Look(layer, plan);
    EXPECT_TRUE(plan.sections.front().curled.empty());
  }
}

TEST(CurlPlanner, ObjectsAreByThemselves) {
  PlanningOptions options = Options();
  options.objects.push_back(options.objects[0]);
  CurlPlanner planner(options);
  std::vector<SlicedLayer> layers = LayersOrDie({kLow, kHigh});
  layers[0].sections.push_back(SectionOrDie(1, 0, kHigh));
  layers[1].sections.push_back(SectionOrDie(1, 1, kHigh));
  LayerPlan plan;
  for (const SlicedLayer& layer : layers) planner.Look(layer, plan);
  EXPECT_FALSE(PlanOf(0, plan).curled.empty());
  EXPECT_TRUE(PlanOf(1, plan).curled.empty());
}

}  // namespace
}  // namespace slicefarm::planning::curl_planner_test
