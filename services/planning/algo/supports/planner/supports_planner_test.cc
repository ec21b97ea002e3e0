#include "services/planning/algo/supports/planner/supports_planner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "common/model/options/planning_options.h"
#include "common/model/options/support_options.h"
#include "common/stage/print_layers.h"
#include "services/planning/algo/job_planner.h"
#include "services/planning/algo/layers_test.h"

namespace slicefarm::planning::supports_planner_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

constexpr std::string_view kStem = "(-3 -3, 3 -3, 3 3, -3 3)";
constexpr std::string_view kArm = "(-3 -3, 20 -3, 20 3, -3 3)";

/// Returns a post of 6 mm with an arm that overhangs by 17 mm at a height of 6 mm.
std::vector<SlicedLayer> Gallows() {
  std::vector<std::string_view> texts(30, kStem);
  texts.insert(texts.end(), 5, kArm);
  std::vector<SlicedLayer> layers = LayersOrDie(texts);
  for (SlicedLayer& layer : layers) layer.sections[0].z_nm = layer.frame.print_z_nm;
  return layers;
}

PlanningOptions With(SupportStyle style, size_t objects = 1) {
  PlanningOptions options;
  options.bed = {{{Mm(0, 0), Mm(200, 0), Mm(200, 200), Mm(0, 200)}, {}}};
  options.objects.resize(objects);
  for (ObjectPlanOptions& object : options.objects) {
    object.support.on = true;
    object.support.style = style;
    object.support_settings = {11, 12, 13, 14, 15};
  }
  return options;
}

JobPlan PlanOrDie(const PlanningOptions& options, const std::vector<PlacedCopy>& copies,
                  const std::vector<SlicedLayer>& parts) {
  const std::vector<std::string> names = {"gallows"};
  auto planner = JobPlanner::Make(options, copies, names);
  EXPECT_TRUE(planner.ok()) << planner.status();
  for (const SlicedLayer& layer : parts) EXPECT_TRUE(planner->Next(layer).ok());
  auto plan = planner->Finish();
  EXPECT_TRUE(plan.ok()) << plan.status();
  return plan.ok() ? *std::move(plan) : JobPlan{};
}

class EveryStyle : public testing::TestWithParam<SupportStyle> {};

TEST_P(EveryStyle, CarriesTheArmByAStackOfItsObject) {
  const JobPlan plan = PlanOrDie(With(GetParam()), {{0, Mm(100, 100), {}}}, Gallows());
  ASSERT_THAT(plan.stacks, SizeIs(1));
  const AddedStack& support = plan.stacks[0];
  EXPECT_EQ(support.stack, Stack(1, 0, StackKind::kSupport));
  ASSERT_FALSE(support.sections.empty());
  // The gap below the arm, which begins at 6 mm, is 0.2 mm.
  EXPECT_EQ(support.sections.back().z_nm, 5'800'000);
  EXPECT_EQ(support.sections.front().z_nm, support.sections.front().height_nm) << "on the bed";
  int32_t layer = 0;
  for (const ObjectSection& section : support.sections) {
    EXPECT_EQ(section.stack, support.stack);
    EXPECT_EQ(section.layer, layer++);
    EXPECT_EQ(section.layer_count, std::ssize(support.sections));
    EXPECT_FALSE(section.regions.empty());
    EXPECT_TRUE(Intersection(OutlineOf(section), MakePolygonsOrDie(kStem)).empty());
  }
  EXPECT_THAT(plan.warnings, IsEmpty());
  const auto print = PrintLayers(Gallows(), plan.lifts_nm, plan.stacks);
  EXPECT_EQ(plan.layers.size(), print.size());
}

TEST_P(EveryStyle, TopsAreInterfaceAndTheFirstLayerHasItsOwnRow) {
  const JobPlan plan = PlanOrDie(With(GetParam()), {{0, Mm(100, 100), {}}}, Gallows());
  const std::vector<ObjectSection>& sections = plan.stacks[0].sections;
  ASSERT_FALSE(sections.empty());
  for (const Region& region : sections.front().regions) EXPECT_EQ(region.settings, 11);
  // Cells of a grid may extend beyond the arm. The area below the arm is interface.
  const MultiPolygon arm = MakePolygonsOrDie("(4 -3, 20 -3, 20 3, 4 3)");
  MultiPolygon interface;
  for (const Region& region : sections.back().regions) {
    if (region.role != Role::kSupportInterface) continue;
    EXPECT_EQ(region.settings, 15);
    interface = region.outlines;
  }
  EXPECT_GT(Area(Intersection(interface, arm)), 0.9 * Area(arm));
}

TEST_P(EveryStyle, ASupportDoesNotRunThroughWhatStandsBesideIt) {
  std::vector<SlicedLayer> layers = Gallows();
  for (int32_t i = 0; i < 20; ++i)
    layers[static_cast<size_t>(i)].sections.push_back(SectionOrDie(1, i, kStem));
  PlanningOptions options = With(GetParam(), 2);
  options.objects[1].support.on = false;
  // The second object is below the arm.
  const JobPlan plan = PlanOrDie(options, {{0, Mm(100, 100), {}}, {1, Mm(112, 100), {}}}, layers);
  ASSERT_THAT(plan.stacks, SizeIs(1));
  const MultiPolygon other = Moved(MakePolygonsOrDie(kStem), Mm(12, 0));
  for (const ObjectSection& section : plan.stacks[0].sections)
    if (section.z_nm - section.height_nm < 4'000'000) {
      EXPECT_TRUE(Intersection(OutlineOf(section), other).empty()) << section.z_nm;
    }
}

INSTANTIATE_TEST_SUITE_P(Styles, EveryStyle,
                         testing::Values(SupportStyle::kGrid, SupportStyle::kSnug,
                                         SupportStyle::kTree));

TEST(SupportsPlanner, CopiesShareOneSupport) {
  const PlanningOptions options = With(SupportStyle::kSnug);
  const JobPlan one = PlanOrDie(options, {{0, Mm(50, 50), {}}}, Gallows());
  const JobPlan two = PlanOrDie(options, {{0, Mm(50, 50), {}}, {0, Mm(150, 150), {}}}, Gallows());
  EXPECT_EQ(one.stacks, two.stacks);
}

TEST(SupportsPlanner, ARaftCarriesSupportsAndLiftsThem) {
  PlanningOptions options = With(SupportStyle::kSnug);
  options.objects[0].raft.heights.layers = 2;
  options.objects[0].raft_settings = {1, 2};
  const JobPlan plan = PlanOrDie(options, {{0, Mm(100, 100), {}}}, Gallows());
  ASSERT_THAT(plan.stacks, SizeIs(2));
  const AddedStack& support = plan.stacks[0];
  const AddedStack& raft = plan.stacks[1];
  EXPECT_EQ(raft.stack.kind, StackKind::kRaft);
  EXPECT_EQ(support.lift_nm, plan.lifts_nm[0]);
  const Coord top_nm = raft.sections.back().z_nm;
  const ObjectSection& first = support.sections.front();
  EXPECT_EQ(support.lift_nm + first.z_nm - first.height_nm, top_nm) << "without a gap";
  EXPECT_GT(Bounds(OutlineOf(raft.sections[0])).max.x, FromMm(20)) << "below the arm too";
}

TEST(SupportsPlanner, LayersThatBeginWithASupportDoNotMeetReady) {
  const PlanningOptions options = With(SupportStyle::kSnug);
  const JobPlan with = PlanOrDie(options, {{0, Mm(100, 100), {}}}, Gallows());
  const JobPlan without = PlanOrDie({}, {{0, Mm(100, 100), {}}}, Gallows());
  EXPECT_TRUE(without.layers[10].begins_ready);
  EXPECT_FALSE(with.layers[10].begins_ready);
  EXPECT_FALSE(with.layers[9].ends_ready);
}

TEST(SupportsPlanner, WhatCannotBeCarriedIsTold) {
  PlanningOptions options = With(SupportStyle::kSnug);
  // A plate below the whole arm. No support may rest on the part.
  std::vector<SlicedLayer> layers = Gallows();
  for (size_t i = 0; i < 3; ++i)
    layers[i].sections[0].regions[0].outlines =
        MakePolygonsOrDie("(-30 -30, 40 -30, 40 30, -30 30)");
  options.objects[0].support.bed_only = true;
  const JobPlan plan = PlanOrDie(options, {{0, Mm(100, 100), {}}}, layers);
  EXPECT_THAT(plan.stacks, IsEmpty());
  ASSERT_FALSE(plan.warnings.empty());
  EXPECT_THAT(plan.warnings[0], HasSubstr("gallows: "));
  EXPECT_THAT(plan.warnings[0], HasSubstr("cannot be supported"));
}

TEST(SupportsPlanner, NothingWithoutWish) {
  PlanningOptions options = With(SupportStyle::kSnug);
  options.objects[0].support.on = false;
  EXPECT_THAT(PlanOrDie(options, {{0, Mm(100, 100), {}}}, Gallows()).stacks, IsEmpty());
}

}  // namespace
}  // namespace slicefarm::planning::supports_planner_test
