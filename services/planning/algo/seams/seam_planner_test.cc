#include "services/planning/algo/seams/seam_planner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "common/model/options/planning_options.h"
#include "services/planning/algo/layers_test.h"
#include "services/planning/algo/seams/rings_test.h"

namespace slicefarm::planning::seam_planner_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Plans the seams of layers. Writes the number of layers finished before the end to `finished`.
JobPlan PlanOfLayers(const std::vector<SlicedLayer>& layers, std::vector<SeamPosition> seams,
                     size_t max_candidates = SeamPlanner::kMaxCandidates,
                     size_t* finished = nullptr) {
  PlanningOptions options;
  options.objects.clear();
  for (const SeamPosition seam : seams) options.objects.push_back({seam});
  SeamPlanner planner(options, max_candidates);
  OpenLayers open;
  JobPlan plan;
  for (const SlicedLayer& layer : layers) {
    planner.Look(layer, open.Add());
    std::ranges::move(open.TakeBelow(planner.Revise(open)), std::back_inserter(plan.layers));
  }
  if (finished != nullptr) *finished = plan.layers.size();
  EXPECT_TRUE(planner.Finish({}, open, plan).ok());
  std::ranges::move(open.TakeBelow(open.end()), std::back_inserter(plan.layers));
  return plan;
}

/// Returns layers of 0.2 mm, one per ring.
std::vector<SlicedLayer> LayersOf(const std::vector<Polygon>& rings) {
  std::vector<SlicedLayer> layers(rings.size());
  for (size_t i = 0; i < rings.size(); ++i) {
    const auto index = static_cast<int32_t>(i);
    layers[i].frame = {index, (index + 1) * Coord{200'000}, 200'000};
    layers[i].sections = {SectionOrDie(0, index, "")};
    layers[i].sections[0].z_nm = layers[i].frame.print_z_nm;
    layers[i].sections[0].regions = {{Role::kPart, 0, 0, {{rings[i], {}}}}};
  }
  return layers;
}

std::vector<Point> FirstSeams(const JobPlan& plan) {
  std::vector<Point> seams;
  for (const LayerPlan& layer : plan.layers) seams.push_back(layer.sections[0].seams[0]);
  return seams;
}

/// Returns the mean distance between each seam and the seam below.
double MeanStepMm(const std::vector<Point>& seams) {
  double sum = 0;
  for (size_t i = 1; i < seams.size(); ++i) sum += ToMm(Distance(seams[i - 1], seams[i]));
  return sum / static_cast<double>(seams.size() - 1);
}

constexpr std::string_view kTwoTowers = "(10 0, 20 0, 20 10, 10 10) ; (90 0, 100 0, 100 10, 90 10)";

TEST(SeamPlanner, SeamsHaveTheOrderOfRings) {
  for (const SeamPosition position :
       {SeamPosition::kRear, SeamPosition::kAligned, SeamPosition::kHidden}) {
    const auto plan = PlanOfLayers(
        LayersOrDie({"(0 0, 20 0, 20 20, 0 20) (5 5, 5 15, 15 15, 15 5)"}), {position});
    ASSERT_EQ(plan.layers[0].sections[0].seams.size(), 2u);
    EXPECT_EQ(plan.layers[0].sections[0].seams[0], Mm(0, 20));
    EXPECT_EQ(plan.layers[0].sections[0].seams[1], Mm(5, 15));
  }
}

TEST(SeamPlanner, NearestHasNoSeams) {
  const auto plan = PlanOfLayers(LayersOrDie({kTwoTowers}), {SeamPosition::kNearest});
  EXPECT_THAT(plan.layers[0].sections, IsEmpty());
  EXPECT_EQ(plan.seams, SeamQuality{});
}

TEST(SeamPlanner, AlignedSeamsStandUpright) {
  const auto plan =
      PlanOfLayers(LayersOrDie({kTwoTowers, kTwoTowers, kTwoTowers}), {SeamPosition::kAligned});
  EXPECT_THAT(plan.layers[0].sections[0].seams, ElementsAre(Mm(10, 10), Mm(90, 10)));
  EXPECT_EQ(plan.layers[1].sections, plan.layers[0].sections);
  EXPECT_EQ(plan.layers[2].sections, plan.layers[0].sections);
  const SeamQuality want = {.loops = 6, .followers = 4, .with_corner = 6, .on_corner = 6};
  EXPECT_EQ(plan.seams, want);
}

TEST(SeamPlanner, PrefersAnInnerCorner) {
  const auto plan =
      PlanOfLayers(LayersOrDie({"(0 0, 10 0, 10 5, 5 5, 5 10, 0 10)"}), {SeamPosition::kAligned});
  EXPECT_EQ(plan.layers[0].sections[0].seams[0], Mm(5, 5));
}

TEST(SeamPlanner, StaysInLineOnARoundPart) {
  // The facets rotate from layer to layer. The seam must not rotate with them.
  for (const SeamPosition position :
       {SeamPosition::kAligned, SeamPosition::kRear, SeamPosition::kHidden}) {
    std::vector<Polygon> rings;
    for (int i = 0; i < 100; ++i) rings.push_back(CircleRing({}, 10, 100, 0.013 * i));
    const std::vector<Point> seams = FirstSeams(PlanOfLayers(LayersOf(rings), {position}));
    EXPECT_LT(MeanStepMm(seams), 0.05);
    for (const Point seam : seams) EXPECT_LT(Distance(seam, seams[0]), FromMm(0.5));
  }
}

TEST(SeamPlanner, FollowsACornerThatTurns) {
  std::vector<Polygon> rings;
  for (int i = 0; i < 100; ++i) rings.push_back(TurnedSquare(20, i * 0.4 / 180 * std::numbers::pi));
  const JobPlan plan = PlanOfLayers(LayersOf(rings), {SeamPosition::kAligned});
  EXPECT_LT(MeanStepMm(FirstSeams(plan)), 0.1);
  EXPECT_EQ(plan.seams.on_corner, 100);
  EXPECT_EQ(plan.seams.jumps, 0);
}

TEST(SeamPlanner, SettlesLowerLayersWhenThereIsTooMuchToKeep) {
  std::vector<Polygon> rings;
  for (int i = 0; i < 200; ++i) rings.push_back(TurnedSquare(20, i * 0.4 / 180 * std::numbers::pi));
  for (const SeamPosition position : {SeamPosition::kAligned, SeamPosition::kRear}) {
    size_t finished = 0;
    const JobPlan whole =
        PlanOfLayers(LayersOf(rings), {position}, SeamPlanner::kMaxCandidates, &finished);
    EXPECT_EQ(finished, 0u);
    const JobPlan banded = PlanOfLayers(LayersOf(rings), {position}, 2'000, &finished);
    EXPECT_GT(finished, 150u);
    ASSERT_EQ(banded.layers.size(), rings.size());
    EXPECT_EQ(banded.seams.loops, 200);
    EXPECT_EQ(banded.seams.followers, 199);
    EXPECT_LE(banded.seams.jumps, whole.seams.jumps);
    EXPECT_LT(MeanStepMm(FirstSeams(banded)), 0.1);
  }
}

TEST(SeamPlanner, SettlesALayerThatIsTooMuchByItself) {
  size_t finished = 0;
  const JobPlan plan = PlanOfLayers(LayersOrDie({kTwoTowers, kTwoTowers, kTwoTowers}),
                                    {SeamPosition::kAligned}, 1, &finished);
  EXPECT_EQ(finished, 3u);
  EXPECT_EQ(plan.seams.jumps, 0);
  for (const LayerPlan& layer : plan.layers) EXPECT_EQ(layer.sections[0].seams.size(), 2u);
}

TEST(SeamPlanner, KeepsAwayFromOverhangs) {
  // A wall that leans out to the rear, where the best corners would be without the overhang.
  std::vector<Polygon> rings;
  for (int i = 0; i < 60; ++i) {
    const double rear = 20 + 0.4 * i;
    rings.push_back({Mm(0, 0), Mm(20, 0), Mm(20, rear), Mm(0, rear)});
  }
  const JobPlan plan = PlanOfLayers(LayersOf(rings), {SeamPosition::kAligned});
  EXPECT_EQ(plan.seams.overhanging, 0);
  EXPECT_EQ(plan.seams.on_corner, 60);
  EXPECT_EQ(plan.seams.jumps, 0);
}

TEST(SeamPlanner, BlockersAreNeverUsedIfThereIsAnotherPlace) {
  std::vector<SlicedLayer> layers = LayersOrDie(std::vector<std::string_view>(30, kTwoTowers));
  for (size_t i = 10; i < 20; ++i) {
    layers[i].sections[0].marks.push_back(
        {PartRole::kSeamBlocker, MakePolygonsOrDie("(-5 9, 200 9, 200 11, -5 11)")});
    layers[i].sections[0].marks.push_back(
        {PartRole::kSeamEnforcer, MakePolygonsOrDie("(88 -1, 92 -1, 92 11, 88 11)")});
  }
  const JobPlan plan = PlanOfLayers(layers, {SeamPosition::kAligned});
  for (size_t i = 10; i < 20; ++i) {
    const std::vector<Point>& seams = plan.layers[i].sections[0].seams;
    EXPECT_LT(seams[0].y, FromMm(9));
    EXPECT_LT(seams[1].y, FromMm(9));
    EXPECT_LE(seams[1].x, FromMm(92));
  }
}

TEST(SeamPlanner, NearestHeedsEnforcersAndBlockersInTheLayersThatHaveThem) {
  std::vector<SlicedLayer> layers = LayersOrDie(std::vector<std::string_view>(9, kTwoTowers));
  layers[3].sections[0].marks.push_back(
      {PartRole::kSeamEnforcer, MakePolygonsOrDie("(98 -1, 102 -1, 102 2, 98 2)")});
  layers[5].sections[0].marks.push_back(
      {PartRole::kSeamBlocker, MakePolygonsOrDie("(-5 9, 200 9, 200 11, -5 11)")});
  const JobPlan plan = PlanOfLayers(layers, {SeamPosition::kNearest});
  for (const size_t i : {0, 1, 2, 4, 6, 7, 8}) EXPECT_THAT(plan.layers[i].sections, IsEmpty());
  EXPECT_EQ(plan.layers[3].sections[0].seams[1], Mm(100, 0));
  for (const Point seam : plan.layers[5].sections[0].seams) EXPECT_LT(seam.y, FromMm(9));
}

TEST(SeamPlanner, RandomSeamsAreElsewhereEachTimeAndTheSameInEachRun) {
  const auto layers = LayersOrDie(std::vector<std::string_view>(60, kTwoTowers));
  const JobPlan plan = PlanOfLayers(layers, {SeamPosition::kRandom});
  EXPECT_EQ(plan, PlanOfLayers(layers, {SeamPosition::kRandom}));
  EXPECT_GT(plan.seams.jumps, plan.seams.followers * 8 / 10);
}

TEST(SeamPlanner, ObjectsDoNotFollowEachOther) {
  std::vector<SlicedLayer> layers = LayersOrDie({"(0 0, 10 0, 10 10)", ""});
  layers[1].sections = {SectionOrDie(1, 0, "(0 0, 10 0, 10 10, 0 10)")};
  const auto plan = PlanOfLayers(layers, {SeamPosition::kAligned, SeamPosition::kAligned});
  EXPECT_EQ(plan.layers[1].sections[0].stack, 1);
  EXPECT_THAT(plan.layers[1].sections[0].seams, ElementsAre(Mm(0, 10)));
  EXPECT_EQ(plan.seams.followers, 0);
}

TEST(SeamPlanner, EachObjectHasItsOwnPosition) {
  std::vector<SlicedLayer> layers = LayersOrDie({kTwoTowers});
  layers[0].sections.push_back(SectionOrDie(1, 0, kTwoTowers));
  const auto plan = PlanOfLayers(layers, {SeamPosition::kNearest, SeamPosition::kRear});
  ASSERT_EQ(plan.layers[0].sections.size(), 1u);
  EXPECT_EQ(plan.layers[0].sections[0].stack, 1);
}

}  // namespace
}  // namespace slicefarm::planning::seam_planner_test
