#include "services/ordering/algo/tours/constructions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/ordering/algo/tours/exact_tour_test.h"

namespace slicefarm::ordering::constructions_test {
namespace {

using ::testing::ElementsAre;

Costs OnALine(const std::vector<double>& xs) {
  std::vector<Vector2> points;
  for (const double x : xs) points.push_back({x, 0});
  return Costs::OfPoints(points, Metric::kNearest);
}

Tour Greedy(const Costs& costs, std::span<const NodePair> fixed = {}, size_t neighbours = 5) {
  return GreedyEdgeTour(costs, Neighbours(costs, neighbours, 0), fixed);
}

TEST(Constructions, GreedyTakesTheShortestEdgesFirst) {
  // The shortest edge is 1-2, the next one is 0-1. Node 3 is joined last.
  EXPECT_THAT(Greedy(OnALine({0, 4, 6, 11})), ElementsAre(0, 1, 2, 3));
}

TEST(Constructions, OfFewOrCoincidentNodes) {
  for (const size_t count : {1, 2, 3, 4, 30}) {
    for (const int range : {1, 100}) {
      const Costs costs = RandomCosts(count, 5, range);
      const auto size = static_cast<int32_t>(count);
      EXPECT_TRUE(Keeps(Greedy(costs), size, {}));
    }
  }
}

TEST(Constructions, GreedyKeepsFixedEdges) {
  const Costs costs = RandomCosts(40, 8);
  const std::vector<NodePair> fixed = {{0, 39}, {39, 20}, {5, 6}, {7, 35}};
  EXPECT_TRUE(Keeps(Greedy(costs, fixed), 40, {.fixed = fixed, .before = {}}));
}

TEST(Constructions, GreedyKeepsARingOfFixedEdges) {
  const Costs costs = RandomCosts(5, 8);
  const std::vector<NodePair> ring = {{0, 3}, {3, 1}, {1, 4}, {4, 2}, {2, 0}};
  EXPECT_TRUE(Keeps(Greedy(costs, ring), 5, {.fixed = ring, .before = {}}));
}

TEST(Constructions, GreedyEndsOpenPathsNowhere) {
  Costs costs = OnALine({0, 1, 2, 3, 9, 8, 7});
  const int32_t nowhere = costs.AddNowhere();
  const std::vector<NodePair> fixed = {{nowhere, 0}};
  const Tour tour = Greedy(costs, fixed);
  EXPECT_TRUE(Keeps(tour, costs.size(), {.fixed = fixed, .before = {}}));
  EXPECT_EQ(TourLength(costs, tour), 9);
}

// Results of J. L. Bentley (1992) and D. S. Johnson, L. A. McGeoch (1997) for such instances.
TEST(Constructions, AreAsGoodAsTheyUsedToBe) {
  for (const auto& [name, optimum] :
       {std::pair("kroA100", 21282), std::pair("berlin52", 7542), std::pair("eil51", 426)}) {
    const Costs costs = CorpusInstance(name).costs;
    const auto ratio = [&, optimum = optimum](const Tour& tour) {
      return static_cast<double>(TourLength(costs, tour)) / optimum;
    };
    EXPECT_LE(ratio(Greedy(costs)), 1.32) << name;
  }
}

}  // namespace
}  // namespace slicefarm::ordering::constructions_test
