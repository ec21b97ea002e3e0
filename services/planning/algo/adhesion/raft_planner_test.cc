#include "services/planning/algo/adhesion/raft_planner.h"

#include <gmock/gmock.h>

#include <string_view>

#include "common/geometry/measure.h"
#include "services/planning/algo/adhesion/planned_test.h"

namespace slicefarm::planning::raft_planner_test {
namespace {

using testing::SizeIs;

constexpr std::string_view kSquare = "(-5 -5, 5 -5, 5 5, -5 5)";

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

TEST(RaftPlanner, ARaftLiesBelowItsPart) {
  PlanningOptions options;
  options.objects = {OnRaft(2)};
  options.objects[0].brim = {.type = BrimType::kOuterOnly, .width_nm = FromMm(3)};
  const Planned plan = PlanOrDie(options, {{0, Mm(50, 50), {}}}, TwoLayers());
  ASSERT_THAT(plan.plan.stacks, SizeIs(1)) << "no brim under an object with a raft";
  const std::vector<ObjectSection>& raft = plan.plan.stacks[0].sections;
  ASSERT_THAT(raft, SizeIs(2));
  ASSERT_THAT(plan.print, SizeIs(4));
  EXPECT_EQ(plan.print[2].frame, (LayerFrame{2, 800'000, 300'000}));
  EXPECT_EQ(plan.print[3].frame, (LayerFrame{3, 1'000'000, 200'000}));
  const MultiPolygon base = RegionsOf(plan, 0, Role::kRaft);
  const MultiPolygon interface = RegionsOf(plan, 1, Role::kRaftInterface);
  EXPECT_EQ(Bounds(base).min.x, FromMm(-5 - 4.5));
  EXPECT_EQ(Bounds(interface).max.y, FromMm(5 + 1.5));
  EXPECT_EQ(raft[0].regions[0].settings, 10);
  EXPECT_EQ(raft[1].regions[0].settings, 11);
  EXPECT_EQ(raft[1].height_nm, 300'000);
}

TEST(RaftPlanner, AnObjectWithRoomAroundItsCopiesHasItsOwn) {
  PlanningOptions options;
  options.objects = {OnRaft(2)};
  const std::vector<PlacedCopy> copies = {{0, {}, {}}, {0, Mm(60, 0), {}}};
  const Planned own = PlanOrDie(options, copies, TwoLayers());
  ASSERT_THAT(own.plan.stacks, SizeIs(1));
  EXPECT_EQ(own.plan.stacks[0].stack, Stack(1, 0, StackKind::kRaft));
  EXPECT_EQ(Bounds(RegionsOf(own, 0, Role::kRaft)).max.x, FromMm(5 + 4.5));
  // The bed's edge cuts the raft of each copy.
  options.bed = {{{Mm(-20, -20), Mm(68, -20), Mm(68, 20), Mm(-20, 20)}, {}}};
  const Planned cut = PlanOrDie(options, copies, TwoLayers());
  ASSERT_THAT(cut.plan.stacks, SizeIs(1));
  EXPECT_EQ(cut.plan.stacks[0].stack.object, kPlateObject);
  EXPECT_EQ(Bounds(RegionsOf(cut, 0, Role::kRaft)).max.x, FromMm(68));
}

TEST(RaftPlanner, CopiesThatStandCloseShareOne) {
  PlanningOptions options;
  options.objects = {OnRaft(2)};
  const Planned near = PlanOrDie(options, {{0, {}, {}}, {0, Mm(12, 0), {}}}, TwoLayers());
  EXPECT_THAT(RegionsOf(near, 0, Role::kRaft), SizeIs(1));
  EXPECT_EQ(near.plan.stacks[0].stack.object, kPlateObject);
}

TEST(RaftPlanner, PartsOfSeveralHeightsMeetInTheLayersOfThePrint) {
  PlanningOptions options;
  options.objects = {OnRaft(1), {}};
  std::vector<SlicedLayer> layers = TwoLayers();
  for (int32_t i = 0; i < 2; ++i)
    layers[static_cast<size_t>(i)].sections.push_back(SectionOrDie(1, i, kSquare));
  const Planned plan = PlanOrDie(options, {{0, {}, {}}, {1, Mm(50, 0), {}}}, layers);
  EXPECT_THAT(plan.plan.lifts_nm, testing::ElementsAre(300'000, 0));
  std::vector<Coord> tops;
  for (const SlicedLayer& layer : plan.print) tops.push_back(layer.frame.print_z_nm);
  EXPECT_THAT(tops, testing::ElementsAre(200'000, 400'000, 500'000, 700'000));
}

}  // namespace
}  // namespace slicefarm::planning::raft_planner_test
