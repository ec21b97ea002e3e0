#include "services/planning/algo/seams/seam_costs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "services/planning/algo/seams/rings_test.h"

namespace slicefarm::planning::seam_costs_test {
namespace {

constexpr float kRightAngle = std::numbers::pi / 2;

SeamCandidate CandidateAt(double x, double y, float turn = 0) {
  SeamCandidate candidate;
  candidate.at = Mm(x, y);
  candidate.turn_rad = turn;
  return candidate;
}

size_t Cheapest(const std::vector<SeamCandidate>& candidates, const std::vector<double>& seen,
                SeamPosition position) {
  const std::vector<double> costs = SeamCosts(candidates, seen, position, {});
  return static_cast<size_t>(std::ranges::min_element(costs) - costs.begin());
}

TEST(SeamCosts, PrefersInnerCornersToOuterOnesToWalls) {
  const std::vector<SeamCandidate> candidates = {CandidateAt(0, 0, kRightAngle), CandidateAt(5, 9),
                                                 CandidateAt(3, 3, -kRightAngle)};
  const auto costs = SeamCosts(candidates, {1, 1, 1}, SeamPosition::kAligned, {});
  EXPECT_NEAR(costs[0], 0.5, 0.02);
  EXPECT_NEAR(costs[1], 3.5, 0.02);
  EXPECT_NEAR(costs[2], 0, 0.02);
}

TEST(SeamCosts, OfEqualsTheRearMostAndThenTheLeftMost) {
  const std::vector<SeamCandidate> square = {
      CandidateAt(0, 0, kRightAngle), CandidateAt(10, 0, kRightAngle),
      CandidateAt(10, 10, kRightAngle), CandidateAt(0, 10, kRightAngle)};
  for (const SeamPosition position :
       {SeamPosition::kAligned, SeamPosition::kRear, SeamPosition::kHidden})
    EXPECT_EQ(Cheapest(square, {1, 1, 1, 1}, position), 3u);
}

TEST(SeamCosts, HiddenPlacesWinTheMoreTheMoreTheModeAsksForIt) {
  const std::vector<SeamCandidate> candidates = {CandidateAt(0, 0, kRightAngle), CandidateAt(0, 0)};
  const std::vector<double> seen = {1, 0.1};
  EXPECT_EQ(Cheapest(candidates, seen, SeamPosition::kAligned), 0u);
  EXPECT_EQ(Cheapest(candidates, seen, SeamPosition::kHidden), 1u);
}

TEST(SeamCosts, RearIsRear) {
  const std::vector<SeamCandidate> candidates = {CandidateAt(0, 9, -kRightAngle),
                                                 CandidateAt(5, 10)};
  EXPECT_EQ(Cheapest(candidates, {0, 1}, SeamPosition::kRear), 1u);
}

TEST(SeamCosts, NoModeLikesOverhangs) {
  for (const SeamPosition position : {SeamPosition::kAligned, SeamPosition::kHidden,
                                      SeamPosition::kRear, SeamPosition::kRandom}) {
    std::vector<SeamCandidate> candidates = {CandidateAt(0, 0), CandidateAt(0, 0)};
    candidates[0].overhang = 2;
    EXPECT_EQ(Cheapest(candidates, {1, 1}, position), 1u);
    std::swap(candidates[0], candidates[1]);
    EXPECT_EQ(Cheapest(candidates, {1, 1}, position), 0u);
  }
}

TEST(SeamCosts, PaintGoesBeforeAll) {
  std::vector<SeamCandidate> candidates = {CandidateAt(0, 0, -kRightAngle), CandidateAt(0, 0),
                                           CandidateAt(0, 0)};
  candidates[0].blocked = true;
  candidates[1].overhang = 9;
  candidates[2].overhang = 9;
  candidates[2].enforced = true;
  EXPECT_EQ(Cheapest(candidates, {1, 1, 1}, SeamPosition::kAligned), 2u);
  candidates[2].blocked = true;
  EXPECT_EQ(Cheapest(candidates, {1, 1, 1}, SeamPosition::kAligned), 1u);
}

TEST(SeamCosts, OfPaintTheMiddleIsBestButForCorners) {
  std::vector<SeamCandidate> candidates = {CandidateAt(0, 0), CandidateAt(1, 9), CandidateAt(2, 0)};
  for (SeamCandidate& candidate : candidates) candidate.enforced = true;
  candidates[0].off_middle_mm = 8;
  candidates[1].off_middle_mm = 1;
  EXPECT_EQ(Cheapest(candidates, {0, 0, 1}, SeamPosition::kAligned), 2u);
  candidates[0].turn_rad = kRightAngle;
  EXPECT_EQ(Cheapest(candidates, {1, 1, 1}, SeamPosition::kAligned), 0u);
}

TEST(SeamCosts, RandomIsTheSameForTheSameRingAndElseAnything) {
  const std::vector<SeamCandidate> candidates(50, CandidateAt(0, 0));
  const std::vector<double> seen(50, 1);
  const auto of = [&](RingNumber number) {
    return SeamCosts(candidates, seen, SeamPosition::kRandom, number);
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
  std::vector<SeamCandidate> candidates = {CandidateAt(0, 0, -kRightAngle), CandidateAt(0, 0)};
  candidates[0].overhang = 5;
  candidates[1].overhang = 4;
  EXPECT_EQ(Cheapest(candidates, {1, 1}, SeamPosition::kAligned), 1u);
}

// Models a screw: none of its layers is steep, and the seam stays in line.
TEST(SeamCosts, TenLayersThatLeanCostLessThanAJump) {
  std::vector<SeamCandidate> candidates = {CandidateAt(0, 0), CandidateAt(0, 0), CandidateAt(0, 0)};
  candidates[1].overhang = 1;
  candidates[2].overhang = 2.43F;
  const auto costs = SeamCosts(candidates, {1, 1, 1}, SeamPosition::kAligned, {});
  const double jump = StepCostOf(SeamPosition::kAligned).jump;
  EXPECT_LT(10 * (costs[1] - costs[0]), jump);
  EXPECT_GT(2 * (costs[2] - costs[0]), jump) << "but not two that are steep";
}

TEST(SeamCosts, TellsOverhangs) {
  SeamCandidate candidate;
  candidate.overhang = 1.4F;
  EXPECT_FALSE(Overhangs(candidate));
  candidate.overhang = 1.5F;
  EXPECT_TRUE(Overhangs(candidate));
}

}  // namespace
}  // namespace slicefarm::planning::seam_costs_test
