#include "services/planning/algo/adhesion/adhesion_planner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "common/geometry/text_format_test.h"
#include "common/model/options/planning_options.h"
#include "services/planning/algo/adhesion/planned_test.h"

namespace slicefarm::planning::adhesion_planner_test {
namespace {

using testing::ElementsAreArray;
using testing::IsEmpty;
using testing::SizeIs;

constexpr std::string_view kSquare = "(-5 -5, 5 -5, 5 5, -5 5)";
constexpr std::string_view kWide = "(-9 -5, 9 -5, 9 5, -9 5)";

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

double Mm2(const MultiPolygon& region) { return Area(region) * 1e-12; }

/// Returns the least distance between two regions, measured from the corners of each.
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
  // The second layer is wider. All loops keep their distance from both layers.
  EXPECT_EQ(Bounds(skirt.loops[1].points).min.x, FromMm(100 - 9 - 6 - 0.2));
  EXPECT_EQ(Bounds(skirt.loops[1].points).max.x, FromMm(150 + 9 + 6 + 0.2));
}

TEST(AdhesionPlanner, ADraftShieldStandsOnAllLayersThatHaveOutlines) {
  const PlanningOptions options = WithSkirt({.loops = 1, .draft_shield = DraftShield::kEnabled});
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

// The brim begins at the outline without the compensation of the first layer.
TEST(AdhesionPlanner, TheBrimKeepsOffTheCompensatedOutlineIfAskedFor) {
  PlanningOptions options = WithBrim(3);
  options.objects[0].brim.foot_nm = FromMm(0.4);
  const auto left = [&] {
    const JobPlan plan = PlanOrDie(options, {{0, Mm(100, 50), {}}}, LayersOrDie({kSquare})).plan;
    EXPECT_EQ(plan.stacks.size(), 1u);
    return Bounds(plan.stacks[0].sections[0].regions[0].outlines).min.x;
  };
  const Coord close = left();
  options.objects[0].brim.compensated = false;
  EXPECT_EQ(left(), close - FromMm(0.4));
}

TEST(AdhesionPlanner, BrimsOfCopiesThatStandCloseAreOneRegion) {
  const Planned plan =
      PlanOrDie(WithBrim(2, 0.1), {{0, Mm(0, 0), {}}, {0, Mm(13, 0), {}}, {0, Mm(60, 0), {}}},
                LayersOrDie({kSquare}));
  ASSERT_THAT(plan.plan.stacks, SizeIs(1));
  EXPECT_EQ(plan.plan.stacks[0].stack, Stack(1, kPlateObject, StackKind::kBrim));
  ASSERT_THAT(plan.plan.stacks[0].sections, SizeIs(1));
  const ObjectSection& section = plan.plan.stacks[0].sections[0];
  ASSERT_THAT(section.regions, SizeIs(1));
  const Region& brim = section.regions[0];
  EXPECT_EQ(brim.role, Role::kBrim);
  EXPECT_EQ(brim.settings, 7);
  EXPECT_EQ(section.height_nm, 200'000);
  ASSERT_THAT(brim.outlines, SizeIs(2));  // one brim around two copies, one around a single copy
  EXPECT_THAT(brim.outlines[0].holes, SizeIs(2));
  EXPECT_THAT(brim.outlines[1].holes, SizeIs(1));
}

TEST(AdhesionPlanner, EachCopyKeepsItsBrimUnlessTheyAreCombined) {
  PlanningOptions options = WithBrim(2, 0.1);
  const std::vector<PlacedCopy> copies = {{0, Mm(0, 0), {}}, {0, Mm(13, 0), {}}};
  const std::vector<SlicedLayer> layers = LayersOrDie({kSquare});
  const MultiPolygon whole = RegionsOf(PlanOrDie(options, copies, layers), 0, Role::kBrim);
  options.combine_brims = false;
  const Planned plan = PlanOrDie(options, copies, layers);
  ASSERT_THAT(plan.plan.stacks, SizeIs(1));
  const std::vector<Region>& regions = plan.plan.stacks[0].sections[0].regions;
  ASSERT_THAT(regions, SizeIs(2));
  for (const Region& region : regions) EXPECT_EQ(region.settings, 7);
  EXPECT_LT(Mm2(Intersection(regions[0].outlines, regions[1].outlines)), 1e-4);
  const MultiPolygon apart = Union(regions[0].outlines, regions[1].outlines);
  EXPECT_NEAR(Mm2(apart), Mm2(whole), 0.05);
  EXPECT_LT(Mm2(Difference(apart, whole)), 1e-2);
}

TEST(AdhesionPlanner, OneLoopOfTheSkirtGoesOn) {
  PlanningOptions options = WithSkirt({.loops = 3, .height_layers = 2});
  options.bed = {{{Mm(-9, -40), Mm(60, -40), Mm(60, 40), Mm(-9, 40)}, {}}};
  const std::vector<PlacedCopy> copies = {{0, {}, {}}, {0, Mm(40, 0), {}}};
  const std::vector<SlicedLayer> layers = LayersOrDie({kSquare, kSquare});
  EXPECT_THAT(PlanOrDie(options, copies, layers).plan.skirt.upper_loops, IsEmpty());
  options.skirt.single_upper = true;
  const Skirt one = PlanOrDie(options, copies, layers).plan.skirt;
  ASSERT_THAT(one.loops, SizeIs(3));
  ASSERT_THAT(one.upper_loops, SizeIs(1));
  EXPECT_EQ(one.upper_loops[0], one.loops[2]) << "the innermost, cut at the bed's edge";
  options.skirt.per_object = true;
  const Skirt each = PlanOrDie(options, copies, layers).plan.skirt;
  ASSERT_THAT(each.loops, SizeIs(6));
  ASSERT_THAT(each.upper_loops, SizeIs(2));
  EXPECT_EQ(each.upper_loops[0], each.loops[2]);
  EXPECT_EQ(each.upper_loops[1], each.loops[5]);
}

TEST(AdhesionPlanner, TheInnermostLoopOnTheBedGoesOn) {
  PlanningOptions options = WithSkirt({.loops = 3, .height_layers = 2});
  options.skirt.single_upper = true;
  // The innermost loop, 11.2 mm from the middle, is completely in the excluded area. The other two
  // are cut at its corners.
  options.bed = {{{Mm(-60, -60), Mm(60, -60), Mm(60, 60), Mm(-60, 60)},
                  {{Mm(-11.3, -11.3), Mm(-11.3, 11.3), Mm(11.3, 11.3), Mm(11.3, -11.3)}}}};
  const Skirt skirt = PlanOrDie(options, {{0, {}, {}}}, LayersOrDie({kSquare, kSquare})).plan.skirt;
  ASSERT_THAT(skirt.loops, SizeIs(8));
  EXPECT_THAT(skirt.upper_loops, ElementsAreArray(skirt.loops.begin() + 4, skirt.loops.end()));
}

TEST(AdhesionPlanner, AnObjectWithRoomAroundItsCopiesHasItsOwnBrim) {
  PlanningOptions options = WithBrim(2, 0.1);
  const std::vector<PlacedCopy> copies = {{0, Mm(0, 0), {}}, {0, Mm(30, 0), {}}};
  const Planned plan = PlanOrDie(options, copies, LayersOrDie({kSquare}));
  ASSERT_THAT(plan.plan.stacks, SizeIs(1));
  EXPECT_EQ(plan.plan.stacks[0].stack, Stack(1, 0, StackKind::kBrim));
  const ObjectSection& section = plan.plan.stacks[0].sections[0];
  EXPECT_EQ(Bounds(OutlineOf(section)).max.x, FromMm(5 + 2.1)) << "around the object's origin";
  // The outlines on the plate do not change.
  options.sequence.complete_objects = true;
  std::vector<PlacedCopy> placed = copies;
  for (PlacedCopy& copy : placed)
    copy.footprint = Moved(MakePolygonsOrDie(kSquare), copy.shift)[0].outer;
  options.sequence.clearance_radius_nm = 0;
  const Planned shared = PlanOrDie(options, placed, LayersOrDie({kSquare}));
  ASSERT_THAT(shared.plan.stacks, SizeIs(1));
  EXPECT_EQ(shared.plan.stacks[0].stack.object, kPlateObject) << "before anything stands";
  MultiPolygon moved;
  for (const PlacedCopy& copy : copies)
    for (const PolygonWithHoles& island : Moved(OutlineOf(section), copy.shift))
      moved.push_back(island);
  const MultiPolygon& on_plate = OutlineOf(shared.plan.stacks[0].sections[0]);
  // Offsets are rounded to nanometres, and the rounding depends on the position.
  EXPECT_LT(Area(Difference(moved, on_plate)), 1e6);
  EXPECT_LT(Area(Difference(on_plate, moved)), 1e6);
}

TEST(AdhesionPlanner, NothingIsOutsideOfTheBed) {
  PlanningOptions options = WithBrim(4);
  options.bed = {{{Mm(-6, -20), Mm(60, -20), Mm(60, 20), Mm(-6, 20)}, {}}};
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
  const MultiPolygon low = RegionsOf(plan, 0, Role::kRaftInterface);  // raft of object 2
  EXPECT_NEAR(Gap(raft, Moved(MakePolygonsOrDie(kWide), Mm(17, 0))), 0.5e6, 10'000)
      << "from the wider layer";
  EXPECT_NEAR(Gap(low, raft), 0.5e6, 10'000);
  const MultiPolygon brim = RegionsOf(plan, 0, Role::kBrim);
  EXPECT_FALSE(brim.empty());
  EXPECT_LT(Mm2(Intersection(brim, raft)), 1e-4);
  EXPECT_EQ(Bounds(plan.plan.skirt.loops[0].points).max.x, FromMm(17 + 5 + 9 + 0.2));
}

TEST(AdhesionPlanner, RefusesASkirtOfTooManyPoints) {
  const PlanningOptions options = WithSkirt({.loops = 500, .draft_shield = DraftShield::kEnabled});
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
