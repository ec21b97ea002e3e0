#include "services/planning/algo/travel/travel_planner.h"

#include <gtest/gtest.h>

#include "services/planning/algo/layers_test.h"

namespace slicefarm::planning::travel_planner_test {
namespace {

std::vector<LayerPlan> Plans(const std::vector<SlicedLayer>& layers,
                             const std::vector<PlacedCopy>& copies) {
  TravelPlanner planner(copies);
  std::vector<LayerPlan> plans(layers.size());
  for (size_t i = 0; i < layers.size(); ++i) planner.Look(layers[i], plans[i]);
  return plans;
}

constexpr std::string_view kTwoTowers = "(10 0, 20 0, 20 10, 10 10) ; (90 0, 100 0, 100 10, 90 10)";
constexpr std::string_view kOneTower = "(-5 -5, 5 -5, 5 5, -5 5)";

TEST(TravelPlanner, GoesToAndFroBetweenTheIslandsOfAnObject) {
  const auto plans =
      Plans(LayersOrDie({kTwoTowers, kTwoTowers, kTwoTowers, kTwoTowers}), {{0, {}, {}}});
  for (size_t i = 1; i < 4; ++i) {
    const bool right = plans[i].sections[0].entry.x >= FromMm(50);
    EXPECT_EQ(right, i % 2 == 1) << "layer " << i << " at " << ToText(plans[i].sections[0].entry);
    EXPECT_EQ(plans[i].entry, plans[i].sections[0].entry);
  }
}

TEST(TravelPlanner, GoesToAndFroBetweenCopies) {
  const std::vector<PlacedCopy> row = {
      {0, {FromMm(50), 0}, {}}, {0, {FromMm(100), 0}, {}}, {0, {FromMm(150), 0}, {}}};
  const auto plans = Plans(LayersOrDie({kOneTower, kOneTower, kOneTower, kOneTower}), row);
  for (size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(plans[i].entry.x > FromMm(100), i % 2 == 1) << "layer " << i;
    EXPECT_EQ(plans[i].sections[0].entry.x >= 0, false) << "whatever the copies do";
  }
}

TEST(TravelPlanner, AnObjectIsEnteredAlikeWhereverItStands) {
  const auto layers = LayersOrDie({kTwoTowers, kTwoTowers});
  const auto here = Plans(layers, {{0, {}, {}}});
  const auto there = Plans(layers, {{0, {FromMm(30), FromMm(-70)}, {}}});
  for (size_t i = 0; i < 2; ++i) EXPECT_EQ(here[i].sections, there[i].sections);
}

TEST(TravelPlanner, EmptyLayersAreSteppedOver) {
  const auto plans = Plans(LayersOrDie({"", kTwoTowers, "", kTwoTowers}), {{0, {}, {}}});
  EXPECT_EQ(plans[3].entry, plans[2].entry);
  EXPECT_EQ(plans[3].sections[0].entry, plans[2].sections[0].entry);
}

TEST(TravelPlanner, AThousandCopiesAreNoBurden) {
  std::vector<PlacedCopy> many;
  for (int i = 0; i < 1'000; ++i) many.push_back({0, {FromMm(i % 32), FromMm(i / 32)}, {}});
  const auto plans = Plans(LayersOrDie(std::vector<std::string_view>(500, kOneTower)), many);
  EXPECT_EQ(plans.size(), 500u);
  EXPECT_EQ(plans[499].entry, plans[497].entry);
}

/// Returns the plans after Finish for layers with the given seams.
OpenLayers Meeting(const std::vector<std::vector<Point>>& seams,
                   const std::vector<PlacedCopy>& copies) {
  TravelPlanner planner(copies);
  OpenLayers layers;
  const auto outlines = LayersOrDie(std::vector<std::string_view>(seams.size(), kTwoTowers));
  for (size_t i = 0; i < seams.size(); ++i) {
    LayerPlan& plan = layers.Add();
    PlanOf(0, plan).seams = seams[i];
    planner.Look(outlines[i], plan);
  }
  JobPlan job;
  EXPECT_TRUE(planner.Finish({}, layers, job).ok());
  return layers;
}

constexpr Point kLeft{20'000'000, 10'000'000}, kRight{90'000'000, 10'000'000};

TEST(TravelPlanner, LayersMeetAtASeamThatGoesOn) {
  const Point step{250'000, 0};
  const PlacedCopy copy{0, {FromMm(1), FromMm(2)}, {}};
  OpenLayers layers = Meeting({{kLeft, kRight}, {kLeft - step, kRight + step}, {}}, {copy});
  EXPECT_FALSE(layers.At(0).begins_ready);
  EXPECT_TRUE(layers.At(0).ends_ready);
  EXPECT_TRUE(layers.At(1).begins_ready);
  EXPECT_FALSE(layers.At(1).ends_ready) << "no seam above";
  EXPECT_FALSE(layers.At(2).begins_ready);
  const SectionPlan& above = layers.At(1).sections[0];
  EXPECT_EQ(layers.At(0).sections[0].exit, kRight + step) << "where the layer below ends";
  EXPECT_EQ(layers.At(1).entry, copy.shift + kRight + step);
  EXPECT_FALSE(above.exit);
}

TEST(TravelPlanner, LayersDoNotMeetAtWallsThatBegin) {
  const Point jump{1'100'000, 0};
  OpenLayers layers = Meeting({{kLeft, kRight}, {kLeft - jump, kRight + jump}}, {{0, {}, {}}});
  EXPECT_FALSE(layers.At(0).ends_ready);
  EXPECT_FALSE(layers.At(1).begins_ready);
  EXPECT_FALSE(layers.At(0).sections[0].exit);
}

TEST(TravelPlanner, LayersOfSeveralCopiesDoNotMeet) {
  OpenLayers layers = Meeting({{kLeft}, {kLeft}}, {{0, {}, {}}, {0, {FromMm(200), 0}, {}}});
  EXPECT_FALSE(layers.At(0).ends_ready);
  EXPECT_FALSE(layers.At(1).begins_ready);
}

}  // namespace
}  // namespace slicefarm::planning::travel_planner_test
