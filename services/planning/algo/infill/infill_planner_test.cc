#include "services/planning/algo/infill/infill_planner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/geometry/measure.h"
#include "common/model/options/infill_options.h"
#include "common/model/options/planning_options.h"
#include "common/stage/job_memory.h"
#include "services/planning/algo/layers_test.h"

namespace slicefarm::planning::infill_planner_test {
namespace {

constexpr int kLayers = 40;

JobPlan PlanFor(const InfillOptions& infill, const std::vector<SlicedLayer>& layers) {
  PlanningOptions options;
  options.infill = {infill};
  const std::vector<std::string> names = {"block"};
  InfillPlanner planner(options, names);
  OpenLayers open;
  JobPlan plan;
  for (const SlicedLayer& layer : layers) planner.Look(layer, open.Add());
  EXPECT_TRUE(planner.Finish({}, open, plan).ok());
  plan.layers = open.TakeBelow(open.end());
  return plan;
}

std::vector<SlicedLayer> Block() {
  auto layers =
      LayersOrDie(std::vector<std::string_view>(kLayers, "(-15 -15, 15 -15, 15 15, -15 15)"));
  for (SlicedLayer& layer : layers) layer.sections[0].z_nm = layer.frame.print_z_nm;
  return layers;
}

InfillOptions Options(FillPattern pattern) {
  return {.top_solid_layers = 3, .bottom_solid_layers = 3, .pattern = pattern, .walls_nm = 900'000};
}

TEST(InfillPlanner, NothingAskedForIsNothingPlanned) {
  const JobPlan plan = PlanFor(Options(FillPattern::kGyroid), Block());
  ASSERT_EQ(plan.layers.size(), kLayers);
  for (const LayerPlan& layer : plan.layers) EXPECT_TRUE(layer.infill.empty());
}

TEST(InfillPlanner, GivesLinesForPatternsOfTheWholeJob) {
  for (const FillPattern pattern :
       {FillPattern::kAdaptiveCubic, FillPattern::kSupportCubic, FillPattern::kLightning}) {
    const JobPlan plan = PlanFor(Options(pattern), Block());
    for (const LayerPlan& layer : plan.layers) {
      ASSERT_EQ(layer.infill.size(), 1u);
      EXPECT_EQ(layer.infill[0].pattern, pattern);
    }
    EXPECT_FALSE(plan.layers[kLayers - 4].infill[0].lines.empty()) << InfoOf(pattern).name;
    EXPECT_TRUE(plan.notes.empty());
  }
}

TEST(InfillPlanner, TellsWhatItKeeps) {
  PlanningOptions options;
  options.infill = {Options(FillPattern::kLightning)};
  const std::vector<std::string> names = {"block"};
  InfillPlanner planner(options, names);
  OpenLayers open;
  EXPECT_EQ(planner.HeldBytes(), 0);
  int64_t expected = 0;
  for (const SlicedLayer& layer : Block()) {
    planner.Look(layer, open.Add());
    expected += MemoryOf(layer);
    EXPECT_EQ(planner.HeldBytes(), expected);
  }
  EXPECT_GT(expected, kLayers * 4 * static_cast<int64_t>(sizeof(Point)));
}

TEST(InfillPlanner, SupportCubicIsDenserBelowTops) {
  const auto layers =
      LayersOrDie(std::vector<std::string_view>(200, "(-15 -15, 15 -15, 15 15, -15 15)"));
  auto raised = layers;
  for (SlicedLayer& layer : raised) layer.sections[0].z_nm = layer.frame.print_z_nm;
  const JobPlan support = PlanFor(Options(FillPattern::kSupportCubic), raised);
  const JobPlan adaptive = PlanFor(Options(FillPattern::kAdaptiveCubic), raised);
  const auto length = [](const JobPlan& plan, size_t layer) {
    double sum = 0;
    for (const Polyline& line : plan.layers[layer].infill[0].lines) sum += Length(line);
    return sum;
  };
  EXPECT_GT(length(support, 190), 1.5 * length(support, 20));
  EXPECT_GT(length(adaptive, 20), 1.5 * length(support, 20));
}

// In PrusaSlicer the planes of one direction are 3 widths / density apart in space. Within a layer
// their distance is larger by sqrt(1.5).
TEST(InfillPlanner, OctreesHaveTheCubesThatADensityMeansInPrusaSlicer) {
  for (const double density : {0.2, 0.4}) {
    InfillOptions options = Options(FillPattern::kAdaptiveCubic);
    options.density = density;
    options.angle_rad = 0;
    const double apart =
        3 * std::sqrt(1.5) * static_cast<double>(options.sparse_width_nm) / density;
    int next_to_each_other = 0;
    for (const LayerPlan& layer : PlanFor(options, Block()).layers) {
      std::vector<double> along_x;
      for (const Polyline& line : layer.infill[0].lines)
        if (line.front().y == line.back().y) along_x.push_back(static_cast<double>(line[0].y));
      std::ranges::sort(along_x);
      for (size_t i = 1; i < along_x.size(); ++i) {
        const double planes = (along_x[i] - along_x[i - 1]) / apart;
        EXPECT_NEAR(planes, std::round(planes), 1e-4);
        if (std::round(planes) == 1) ++next_to_each_other;
      }
    }
    EXPECT_GT(next_to_each_other, kLayers / 2);
  }
}

TEST(InfillPlanner, SaysWhatItChoseAndWhy) {
  InfillOptions options = Options(FillPattern::kGrid);
  options.choose_pattern = true;
  const JobPlan plan = PlanFor(options, Block());
  ASSERT_EQ(plan.notes.size(), 1u);
  EXPECT_EQ(
      plan.notes[0].rfind("fill_pattern = auto: cubic for block (20 % density, 8.0 mm high", 0), 0u)
      << plan.notes[0];
  EXPECT_EQ(plan.layers[5].infill[0].pattern, FillPattern::kCubic);
  options.goal = FillGoal::kTime;
  options.density = 0.08;
  const JobPlan airy = PlanFor(options, Block());
  EXPECT_EQ(airy.layers[5].infill[0].pattern, FillPattern::kLightning);
  EXPECT_FALSE(airy.layers[kLayers - 4].infill[0].lines.empty());
}

TEST(InfillPlanner, GivesPlacesForLayersThatArePrintedAtOnce) {
  InfillOptions options = Options(FillPattern::kGrid);
  options.every_layers = 2;
  const JobPlan plan = PlanFor(options, Block());
  EXPECT_EQ(plan.layers[5].infill[0].left_out, plan.layers[6].infill[0].combined);
  EXPECT_EQ(plan.layers[6].infill[0].combined_height_nm, 400'000);
  EXPECT_FALSE(plan.layers[6].infill[0].combined.empty());
}

TEST(InfillPlanner, NoDensityNoLines) {
  InfillOptions options = Options(FillPattern::kLightning);
  options.density = 0;
  const JobPlan plan = PlanFor(options, Block());
  ASSERT_EQ(plan.layers.size(), kLayers);
  for (const LayerPlan& layer : plan.layers) EXPECT_TRUE(layer.infill[0].lines.empty());
}

}  // namespace
}  // namespace slicefarm::planning::infill_planner_test
