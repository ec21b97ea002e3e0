#include "services/planning/algo/air/air_planner.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "common/model/options/planning_options.h"
#include "services/planning/algo/job_planner.h"
#include "services/planning/algo/layers_test.h"

namespace slicefarm::planning::air_planner_test {
namespace {

constexpr std::string_view kFrame = "(0 0, 30 0, 30 30, 0 30) (10 10, 10 20, 20 20, 20 10)";
constexpr std::string_view kPlate = "(0 0, 30 0, 30 30, 0 30)";

std::vector<double> AirMm2(bool find_air) {
  PlanningOptions options;
  options.find_air = find_air;
  const std::vector<PlacedCopy> copies = {{0, {}, {}}};
  auto planner = JobPlanner::Make(options, copies);
  EXPECT_TRUE(planner.ok()) << planner.status();
  for (const SlicedLayer& layer : LayersOrDie({kPlate, kFrame, kPlate, kPlate}))
    EXPECT_TRUE(planner->Next(layer).ok());
  const auto plan = planner->Finish();
  EXPECT_TRUE(plan.ok()) << plan.status();
  std::vector<double> areas;
  for (const LayerPlan& layer : plan->layers)
    for (const SectionPlan& section : layer.sections) areas.push_back(Area(section.air) / 1e12);
  return areas;
}

TEST(AirPlanner, FindsTheAreaWithNothingBelow) {
  EXPECT_EQ(AirMm2(true), (std::vector<double>{0, 0, 100, 0}));
}

TEST(AirPlanner, IsAskedFor) {
  const std::vector<double> areas = AirMm2(false);
  ASSERT_FALSE(areas.empty());
  for (const double area : areas) EXPECT_EQ(area, 0);
}

TEST(AirPlanner, AreaAboveSupportsIsNoAir) {
  AirPlanner planner;
  const std::vector<SlicedLayer> layers = LayersOrDie({kFrame, kPlate});
  LayerPlan plan;
  planner.Look(layers[0], plan);
  PlanOf(0, plan).above_supports = MakePolygonsOrDie("(10 10, 20 10, 20 15, 10 15)");
  planner.Look(layers[1], plan);
  EXPECT_EQ(PlanOf(0, plan).air, MakePolygonsOrDie("(10 15, 20 15, 20 20, 10 20)"));
}

}  // namespace
}  // namespace slicefarm::planning::air_planner_test
