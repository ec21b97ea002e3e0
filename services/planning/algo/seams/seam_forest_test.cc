#include "services/planning/algo/seams/seam_forest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "services/planning/algo/seams/rings_test.h"

namespace slicefarm::planning::seam_forest_test {
namespace {

using testing::ElementsAre;

double CostOf(const std::vector<SeamNode>& nodes, const std::vector<int32_t>& chosen,
              const StepCost& step) {
  double cost = 0;
  const auto candidate = [&](size_t node) {
    return nodes[node].candidates[static_cast<size_t>(chosen[node])];
  };
  for (size_t i = 0; i < nodes.size(); ++i) {
    cost += nodes[i].costs[static_cast<size_t>(chosen[i])];
    if (nodes[i].parent >= 0)
      cost += step.Of(candidate(static_cast<size_t>(nodes[i].parent)), candidate(i),
                      nodes[i].away_mm[static_cast<size_t>(chosen[i])]);
  }
  return cost;
}

/// Tries all choices.
double LeastCost(const std::vector<SeamNode>& nodes, const StepCost& step) {
  std::vector<int32_t> chosen(nodes.size(), 0);
  double least = std::numeric_limits<double>::infinity();
  for (;;) {
    least = std::min(least, CostOf(nodes, chosen, step));
    size_t i = 0;
    while (i < nodes.size() && ++chosen[i] == std::ssize(nodes[i].candidates)) chosen[i++] = 0;
    if (i == nodes.size()) return least;
  }
}

TEST(SeamForest, CostsNoMoreThanTheBestOfAllChoices) {
  std::mt19937 random(7);
  const auto up_to = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int turn = 0; turn < 300; ++turn) {
    std::vector<SeamNode> nodes(static_cast<size_t>(1 + up_to(7)));
    for (size_t i = 0; i < nodes.size(); ++i) {
      // The parent is any earlier ring, so there are chains, splits and several roots.
      nodes[i].parent = i == 0 ? -1 : up_to(static_cast<int>(i) + 1) - 1;
      for (int p = up_to(4); p >= 0; --p) {
        nodes[i].candidates.push_back(Mm(0.25 * up_to(20), 0.25 * up_to(4)));
        nodes[i].costs.push_back(0.5 * up_to(8));
        nodes[i].away_mm.push_back(0.25 * up_to(4));
      }
    }
    const StepCost step{.longest_mm = 1,
                        .per_mm = 0.5 * up_to(5),
                        .per_mm2_sideways = 0.5 * up_to(3),
                        .jump = 0.5 * up_to(9)};
    const std::vector<int32_t> chosen = CheapestSeams(nodes, step);
    ASSERT_EQ(chosen.size(), nodes.size());
    EXPECT_DOUBLE_EQ(CostOf(nodes, chosen, step), LeastCost(nodes, step)) << turn;
  }
}

TEST(SeamForest, JumpsOnceForAWallThatIsBetterFromThereOn) {
  std::vector<SeamNode> nodes;
  for (int i = 0; i < 20; ++i) {
    const bool low = i < 10;
    nodes.push_back({i - 1, {Mm(0, 0), Mm(30, 0)}, {low ? 0.0 : 2.0, low ? 2.0 : 0.0}, {}});
  }
  const std::vector<int32_t> chosen = CheapestSeams(nodes, {0.8, 4, 0, 5});
  for (int i = 0; i < 20; ++i) EXPECT_EQ(chosen[static_cast<size_t>(i)], i < 10 ? 0 : 1);
}

TEST(SeamForest, StaysForAFewLayersThatAreBetterElsewhere) {
  std::vector<SeamNode> nodes;
  for (int i = 0; i < 20; ++i) {
    const bool bad = i == 9 || i == 10;
    nodes.push_back({i - 1, {Mm(0, 0), Mm(30, 0)}, {bad ? 2.0 : 0.0, 1}, {}});
  }
  EXPECT_THAT(CheapestSeams(nodes, {0.8, 4, 0, 5}), testing::Each(0));
}

// Models the flat top of a dome: each ring is a millimetre inside the ring below.
TEST(SeamForest, StepsThatAWallAsksForAreNoJumps) {
  std::vector<SeamNode> nodes;
  for (int i = 0; i < 8; ++i) {
    const double radius = 10 - i;
    nodes.push_back({i - 1, {Mm(radius, 0), Mm(0, radius)}, {0, i == 4 ? 0.0 : 0.5}, {1, 1}});
    nodes.back().costs[0] = i == 4 ? 1 : 0;
  }
  nodes[0].away_mm = {0, 0};
  EXPECT_THAT(CheapestSeams(nodes, {}), testing::Each(0)) << "in line in spite of a better place";
  const StepCost step;
  EXPECT_EQ(step.Of(Mm(10, 0), Mm(9, 0), 1), step.per_mm);
  EXPECT_NEAR(step.Of(Mm(10, 0), Mm(9, 0.5), 1), 4 * std::sqrt(1.25) + 4 * 0.25, 1e-9);
  EXPECT_EQ(step.Of(Mm(10, 0), Mm(9, 0.9), 1), step.jump);
}

TEST(SeamForest, BothPartsOfASplitFollowTheirCommonRing) {
  const std::vector<SeamNode> nodes = {{-1, {Mm(0, 0), Mm(10, 0)}, {0, 0.5}, {}},
                                       {0, {Mm(0, 0), Mm(10, 0)}, {1, 0}, {}},
                                       {0, {Mm(0, 0), Mm(10, 0)}, {1, 0}, {}}};
  EXPECT_THAT(CheapestSeams(nodes, {}), ElementsAre(1, 1, 1));
}

TEST(SeamForest, TakesTheFirstOfEquals) {
  const SeamNode node{-1, {Mm(3, 0), Mm(1, 0), Mm(2, 0)}, {1, 1, 1}, {}};
  SeamNode follower = node;
  follower.parent = 0;
  EXPECT_THAT(CheapestSeams(std::vector{node, follower}, StepCost{0, 0, 0, 0}), ElementsAre(0, 0));
  EXPECT_THAT(CheapestSeams({}, {}), ElementsAre());
}

}  // namespace
}  // namespace slicefarm::planning::seam_forest_test
