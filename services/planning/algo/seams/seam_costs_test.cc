#include "services/planning/algo/seams/seam_costs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "services/planning/algo/seams/rings_test.h"

namespace slicefarm::planning::seam_costs_test {
namespace {

constexpr float kRightAngle = std::numbers::pi / 2;

SeamPlace PlaceAt(double x, double y, float turn = 0) {
  SeamPlace place;
  place.at = Mm(x, y);
  place.turn_rad = turn;
  return place;
}

size_t Cheapest(const std::vector<SeamPlace>& places, const std::vector<double>& seen,
                SeamPosition position) {
  const std::vector<double> costs = SeamCosts(places, seen, position, {});
  return static_cast<size_t>(std::ranges::min_element(costs) - costs.begin());
}

TEST(SeamCosts, PrefersInnerCornersToOuterOnesToWalls) {
  const std::vector<SeamPlace> places = {PlaceAt(0, 0, kRightAngle), PlaceAt(5, 9),
                                         PlaceAt(3, 3, -kRightAngle)};
  const auto costs = SeamCosts(places, {1, 1, 1}, SeamPosition::kAligned, {});
  EXPECT_NEAR(costs[0], 0.5, 0.02);
  EXPECT_NEAR(costs[1], 3.5, 0.02);
  EXPECT_NEAR(costs[2], 0, 0.02);
}

TEST(SeamCosts, OfEqualsTheRearMostAndThenTheLeftMost) {
  const std::vector<SeamPlace> square = {PlaceAt(0, 0, kRightAngle), PlaceAt(10, 0, kRightAngle),
                                         PlaceAt(10, 10, kRightAngle), PlaceAt(0, 10, kRightAngle)};
  for (const SeamPosition position :
       {SeamPosition::kAligned, SeamPosition::kRear, SeamPosition::kHidden})
    EXPECT_EQ(Cheapest(square, {1, 1, 1, 1}, position), 3u);
}

TEST(SeamCosts, HiddenPlacesWinTheMoreTheMoreTheModeAsksForIt) {
  const std::vector<SeamPlace> places = {PlaceAt(0, 0, kRightAngle), PlaceAt(0, 0)};
  const std::vector<double> seen = {1, 0.1};
  EXPECT_EQ(Cheapest(places, seen, SeamPosition::kAligned), 0u);
  EXPECT_EQ(Cheapest(places, seen, SeamPosition::kHidden), 1u);
}

TEST(SeamCosts, RearIsRear) {
  const std::vector<SeamPlace> places = {PlaceAt(0, 9, -kRightAngle), PlaceAt(5, 10)};
  EXPECT_EQ(Cheapest(places, {0, 1}, SeamPosition::kRear), 1u);
}

TEST(SeamCosts, NoModeLikesOverhangs) {
  for (const SeamPosition position : {SeamPosition::kAligned, SeamPosition::kHidden,
                                      SeamPosition::kRear, SeamPosition::kRandom}) {
    std::vector<SeamPlace> places = {PlaceAt(0, 0), PlaceAt(0, 0)};
    places[0].overhang = 2;
    EXPECT_EQ(Cheapest(places, {1, 1}, position), 1u);
    std::swap(places[0], places[1]);
    EXPECT_EQ(Cheapest(places, {1, 1}, position), 0u);
  }
}

TEST(SeamCosts, PaintGoesBeforeAll) {
  std::vector<SeamPlace> places = {PlaceAt(0, 0, -kRightAngle), PlaceAt(0, 0), PlaceAt(0, 0)};
  places[0].blocked = true;
  places[1].overhang = 9;
  places[2].overhang = 9;
  places[2].enforced = true;
  EXPECT_EQ(Cheapest(places, {1, 1, 1}, SeamPosition::kAligned), 2u);
  places[2].blocked = true;
  EXPECT_EQ(Cheapest(places, {1, 1, 1}, SeamPosition::kAligned), 1u);
}

TEST(SeamCosts, OfPaintTheMiddleIsBestButForCorners) {
  std::vector<SeamPlace> places = {PlaceAt(0, 0), PlaceAt(1, 9), PlaceAt(2, 0)};
  for (SeamPlace& place : places) place.enforced = true;
  places[0].off_middle_mm = 8;
  places[1].off_middle_mm = 1;
  EXPECT_EQ(Cheapest(places, {0, 0, 1}, SeamPosition::kAligned), 2u);
  places[0].turn_rad = kRightAngle;
  EXPECT_EQ(Cheapest(places, {1, 1, 1}, SeamPosition::kAligned), 0u);
}

TEST(SeamCosts, RandomIsTheSameForTheSameRingAndElseAnything) {
  const std::vector<SeamPlace> places(50, PlaceAt(0, 0));
  const std::vector<double> seen(50, 1);
  const auto of = [&](RingNumber number) {
    return SeamCosts(places, seen, SeamPosition::kRandom, number);
  };
  EXPECT_EQ(of({1, 2, 3}), of({1, 2, 3}));
  std::set<size_t> taken;
  for (int32_t layer = 0; layer < 200; ++layer) {
    const auto costs = of({0, layer, 0});
    taken.insert(static_cast<size_t>(std::ranges::min_element(costs) - costs.begin()));
  }
  EXPECT_GT(taken.size(), 40u);
  EXPECT_EQ(StepCostOf(SeamPosition::kRandom).Of({}, Mm(50, 0), 0), 0);
  EXPECT_GT(StepCostOf(SeamPosition::kAligned).Of({}, Mm(50, 0), 0), 1);
}

TEST(SeamCosts, WhereAllHangsOverTheLeastIsBest) {
  std::vector<SeamPlace> places = {PlaceAt(0, 0, -kRightAngle), PlaceAt(0, 0)};
  places[0].overhang = 5;
  places[1].overhang = 4;
  EXPECT_EQ(Cheapest(places, {1, 1}, SeamPosition::kAligned), 1u);
}

// Models a screw: none of its layers is steep, and the seam stays in line.
TEST(SeamCosts, TenLayersThatLeanCostLessThanAJump) {
  std::vector<SeamPlace> places = {PlaceAt(0, 0), PlaceAt(0, 0), PlaceAt(0, 0)};
  places[1].overhang = 1;
  places[2].overhang = 2.43F;
  const auto costs = SeamCosts(places, {1, 1, 1}, SeamPosition::kAligned, {});
  const double jump = StepCostOf(SeamPosition::kAligned).jump;
  EXPECT_LT(10 * (costs[1] - costs[0]), jump);
  EXPECT_GT(2 * (costs[2] - costs[0]), jump) << "but not two that are steep";
}

TEST(SeamCosts, TellsOverhangs) {
  SeamPlace place;
  place.overhang = 1.4F;
  EXPECT_FALSE(Overhangs(place));
  place.overhang = 1.5F;
  EXPECT_TRUE(Overhangs(place));
}

}  // namespace
}  // namespace slicefarm::planning::seam_costs_test
