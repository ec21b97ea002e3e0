#include "services/planning/algo/adhesion/adhesion_planner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "common/geometry/text_format.h"
#include "common/stage/print_layers.h"
#include "services/planning/algo/job_planner.h"
#include "services/planning/algo/layers_test.h"

namespace slicefarm::planning::adhesion_planner_test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr std::string_view kSquare = "(-5 -5, 5 -5, 5 5, -5 5)";
constexpr std::string_view kWide = "(-9 -5, 9 -5, 9 5, -9 5)";

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

double Mm2(const MultiPolygon& region) { return Area(region) * 1e-12; }

/// What is planned, and the layers of the print.
struct Planned {
  JobPlan plan;
  std::vector<SlicedLayer> print;
};

/// All regions of a role in a layer.
MultiPolygon RegionsOf(const Planned& planned, size_t layer, Role role) {
  MultiPolygon all;
  for (const ObjectSection& section : planned.print[layer].sections)
    for (const Region& region : section.regions)
      if (region.role == role)
        all.insert(all.end(), region.outlines.begin(), region.outlines.end());
  return all;
}

absl::StatusOr<Planned> Plan(const PlanningOptions& options, const std::vector<PlacedCopy>& copies,
                             const std::vector<SlicedLayer>& parts) {
  auto planner = JobPlanner::Make(options, copies);
  if (!planner.ok()) return planner.status();
  for (const SlicedLayer& layer : parts)
    if (absl::Status ok = planner->Next(layer); !ok.ok()) return ok;
  auto plan = planner->Finish();
  if (!plan.ok()) return plan.status();
  auto print = PrintLayers(parts, plan->lifts_nm, plan->stacks);
  EXPECT_EQ(print.size(), plan->layers.size());
  return Planned{*std::move(plan), std::move(print)};
}

Planned PlanOrDie(const PlanningOptions& options, const std::vector<PlacedCopy>& copies,
                  const std::vector<SlicedLayer>& parts) {
  auto plan = Plan(options, copies, parts);
  EXPECT_TRUE(plan.ok()) << plan.status();
  return plan.ok() ? *std::move(plan) : Planned{};
}

/// The least distance from the corners of a region to another, and the other way round.
double Gap(const MultiPolygon& a, const MultiPolygon& b) {
  double gap = INFINITY;
  ForEachRing(a, [&](const Polygon& ring) {
    for (const Point p : ring) gap = std::min(gap, DistanceToRegion(p, b));
  });
  ForEachRing(b, [&](const Polygon& ring) {
    for (const Point p : ring) gap = std::min(gap, DistanceToRegion(p, a));
  });
  return gap;
}

PlanningOptions WithSkirt(SkirtOptions skirt) {
  PlanningOptions options;
  options.skirt = skirt;
  options.skirt_settings = 3;
  return options;
}

PlanningOptions WithBrim(double width_mm, double separation_mm = 0) {
  PlanningOptions options;
  options.objects[0].brim = {.type = BrimType::kOuterOnly,
                             .width_nm = FromMm(width_mm),
                             .separation_nm = FromMm(separation_mm)};
  options.objects[0].brim_settings = 7;
  return options;
}

ObjectPlanOptions OnRaft(int32_t layers) {
  ObjectPlanOptions object;
  object.raft.heights.layers = layers;
  for (int32_t i = 0; i < layers; ++i) object.raft_settings.push_back(10 + i);
  return object;
}

/// Two layers of 0.2 mm. On a raft of two, of 0.2 and 0.3, and 0.1 of air, they end at 0.8 and 1.0.
std::vector<SlicedLayer> TwoLayers() { return LayersOrDie({kSquare, kSquare}); }

TEST(AdhesionPlanner, NothingWithoutWish) {
  const JobPlan plan = PlanOrDie({}, {{0, {}, {}}}, LayersOrDie({kSquare})).plan;
  EXPECT_THAT(plan.stacks, IsEmpty());
  EXPECT_EQ(plan.skirt, Skirt{});
  EXPECT_THAT(plan.lifts_nm, IsEmpty());
}

TEST(AdhesionPlanner, TheSkirtGoesRoundAllCopiesAndAllItsLayers) {
  const PlanningOptions options = WithSkirt({.loops = 2, .height_layers = 2});
  const Skirt skirt = PlanOrDie(options, {{0, Mm(100, 50), {}}, {0, Mm(150, 50), {}}},
                                LayersOrDie({kSquare, kWide, kSquare}))
                          .plan.skirt;
  EXPECT_EQ(skirt.layers, 2);
  ASSERT_THAT(skirt.loops, SizeIs(2));
  EXPECT_EQ(skirt.loops[0].settings, 3);
  // The second layer is wider: all loops keep away from both.
  EXPECT_EQ(Bounds(skirt.loops[1].points).min.x, FromMm(100 - 9 - 6 - 0.2));
  EXPECT_EQ(Bounds(skirt.loops[1].points).max.x, FromMm(150 + 9 + 6 + 0.2));
}

TEST(AdhesionPlanner, ADraftShieldStandsOnAllLayersThatHaveOutlines) {
  const PlanningOptions options =
      WithSkirt({.loops = 1, .draft_shield = DraftShield::kEnabled});
  const Skirt skirt =
      PlanOrDie(options, {{0, {}, {}}}, LayersOrDie({kSquare, "", kWide, "", ""})).plan.skirt;
  EXPECT_EQ(skirt.layers, 3);
  EXPECT_THAT(skirt.loops, SizeIs(1));
}

TEST(AdhesionPlanner, BrimsGiveWayToADraftShieldAndSkirtsToBrims) {
  PlanningOptions options = WithBrim(8);
  options.skirt = {.loops = 1, .distance_nm = FromMm(3)};
  const std::vector<SlicedLayer> layers = LayersOrDie({kSquare});
  const Planned skirt = PlanOrDie(options, {{0, {}, {}}}, layers);
  EXPECT_EQ(Bounds(RegionsOf(skirt, 0, Role::kBrim)).max.x, FromMm(13));
  EXPECT_EQ(Bounds(skirt.plan.skirt.loops[0].points).max.x, FromMm(16.2));
  options.skirt.draft_shield = DraftShield::kLimited;
  const Planned shield = PlanOrDie(options, {{0, {}, {}}}, layers);
  EXPECT_EQ(Bounds(shield.plan.skirt.loops[0].points).max.x, FromMm(8.2));
  EXPECT_EQ(Bounds(RegionsOf(shield, 0, Role::kBrim)).max.x, FromMm(8)) << "up to the line's edge";
}

TEST(AdhesionPlanner, BrimsOfCopiesThatStandCloseAreOneRegion) {
  const Planned plan = PlanOrDie(WithBrim(2, 0.1), {{0, Mm(0, 0), {}}, {0, Mm(13, 0), {}},
                                                    {0, Mm(60, 0), {}}}, LayersOrDie({kSquare}));
  ASSERT_THAT(plan.plan.stacks, SizeIs(1));
  ASSERT_THAT(plan.plan.stacks[0].sections, SizeIs(1));
  const ObjectSection& section = plan.plan.stacks[0].sections[0];
  ASSERT_THAT(section.regions, SizeIs(1));
  const Region& brim = section.regions[0];
  EXPECT_EQ(brim.role, Role::kBrim);
  EXPECT_EQ(brim.settings, 7);
  EXPECT_EQ(section.height_nm, 200'000);
  ASSERT_THAT(brim.outlines, SizeIs(2));  // two together, one alone
  EXPECT_THAT(brim.outlines[0].holes, SizeIs(2));
  EXPECT_THAT(brim.outlines[1].holes, SizeIs(1));
}

TEST(AdhesionPlanner, NothingIsOutsideOfTheBed) {
  PlanningOptions options = WithBrim(4);
  options.bed = {Mm(-6, -20), Mm(60, -20), Mm(60, 20), Mm(-6, 20)};
  options.skirt = {.loops = 2};
  const Planned plan = PlanOrDie(options, {{0, {}, {}}}, LayersOrDie({kSquare}));
  const MultiPolygon brim = RegionsOf(plan, 0, Role::kBrim);
  EXPECT_EQ(Bounds(brim).min.x, FromMm(-6));
  EXPECT_EQ(Bounds(brim).max.x, FromMm(9));
  const std::vector<Path> lines = plan.plan.skirt.loops;
  ASSERT_THAT(lines, SizeIs(2));
  for (const Path& line : lines) {
    EXPECT_FALSE(line.closed);
    EXPECT_EQ(Bounds(line.points).min.x, FromMm(-6 + 0.2));
    EXPECT_LT(Bounds(line.points).max.x, FromMm(17));
  }
}

TEST(AdhesionPlanner, ARaftLiesBelowItsPart) {
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
  EXPECT_EQ(Bounds(base).min.x, FromMm(50 - 5 - 4.5));
  EXPECT_EQ(Bounds(interface).max.y, FromMm(50 + 5 + 1.5));
  EXPECT_EQ(raft[0].regions[0].settings, 10);
  EXPECT_EQ(raft[1].regions[0].settings, 11);
  EXPECT_EQ(raft[1].height_nm, 300'000);
}

TEST(AdhesionPlanner, CopiesShareARaft) {
  PlanningOptions options;
  options.objects = {OnRaft(2)};
  const Planned near = PlanOrDie(options, {{0, {}, {}}, {0, Mm(12, 0), {}}}, TwoLayers());
  EXPECT_THAT(RegionsOf(near, 0, Role::kRaft), SizeIs(1));
  const Planned far = PlanOrDie(options, {{0, {}, {}}, {0, Mm(60, 0), {}}}, TwoLayers());
  EXPECT_THAT(RegionsOf(far, 0, Role::kRaft), SizeIs(2));
}

TEST(AdhesionPlanner, ARaftKeepsAwayFromWhatItDoesNotCarry) {
  PlanningOptions options;
  options.objects = {OnRaft(2), {}, OnRaft(1)};
  std::vector<SlicedLayer> layers = TwoLayers();
  layers[0].sections.push_back(SectionOrDie(1, 0, kSquare));
  layers[1].sections.push_back(SectionOrDie(1, 1, kWide));
  layers[0].sections.push_back(SectionOrDie(2, 0, kSquare));
  options.objects[1].brim = {.type = BrimType::kOuterOnly, .width_nm = FromMm(9)};
  options.skirt = {.loops = 1, .distance_nm = 0};
  const Planned plan =
      PlanOrDie(options, {{0, {}, {}}, {1, Mm(17, 0), {}}, {2, Mm(-12, 0), {}}}, layers);
  const MultiPolygon raft = RegionsOf(plan, 0, Role::kRaft);
  const MultiPolygon low = RegionsOf(plan, 0, Role::kRaftInterface);  // of object 2
  EXPECT_NEAR(Gap(raft, Moved(MakePolygonsOrDie(kWide), Mm(17, 0))), 0.5e6, 10'000)
      << "from the wider layer";
  EXPECT_NEAR(Gap(low, raft), 0.5e6, 10'000);
  const MultiPolygon brim = RegionsOf(plan, 0, Role::kBrim);
  EXPECT_FALSE(brim.empty());
  EXPECT_LT(Mm2(Intersection(brim, raft)), 1e-4);
  EXPECT_EQ(Bounds(plan.plan.skirt.loops[0].points).max.x, FromMm(17 + 5 + 9 + 0.2));
}

TEST(AdhesionPlanner, PartsOfSeveralHeightsMeetInTheLayersOfThePrint) {
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

TEST(AdhesionPlanner, RefusesASkirtOfTooManyPoints) {
  const PlanningOptions options =
      WithSkirt({.loops = 500, .draft_shield = DraftShield::kEnabled});
  std::vector<SlicedLayer> layers(2'000);
  for (int32_t i = 0; i < 2'000; ++i) layers[i].frame = {i, (i + 1) * Coord{200'000}, 200'000};
  layers.front().sections = layers.back().sections = {SectionOrDie(0, 0, kSquare)};
  const auto plan = Plan(options, {{0, {}, {}}}, layers);
  EXPECT_EQ(DetailOf(plan.status()).reason, Reason::kRequestTooLarge) << plan.status();
}

TEST(AdhesionPlanner, WorksOnWhereCoordinatesEnd) {
  PlanningOptions options = WithBrim(200);
  options.skirt = {.loops = 1, .distance_nm = FromMm(50)};
  const Planned plan = PlanOrDie(options, {{0, Mm(2'090, -2'090), {}}}, LayersOrDie({kSquare}));
  const MultiPolygon brim = RegionsOf(plan, 0, Role::kBrim);
  EXPECT_EQ(Bounds(brim).max.x, 2'100'000'000);
}

}  // namespace
}  // namespace slicefarm::planning::adhesion_planner_test
