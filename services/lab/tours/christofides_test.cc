#include "services/lab/tours/christofides.h"

#include <gtest/gtest.h>

#include <bit>
#include <numeric>

#include "services/ordering/algo/tours/exact_tour_test.h"

namespace slicefarm::lab::christofides_test {
namespace {

using ordering::Costs;
using ordering::NodePair;
using ordering::Tour;

/// Returns the least sum of lengths of pairs, by dynamic programming over sets.
int64_t LightestPairs(const Costs& costs) {
  const auto size = static_cast<size_t>(costs.size());
  std::vector<int64_t> least(size_t{1} << size, std::numeric_limits<int64_t>::max() / 4);
  least[0] = 0;
  for (size_t set = 0; set + 1 < least.size(); ++set) {
    const auto a = static_cast<size_t>(std::countr_one(set));
    for (size_t b = a + 1; b < size; ++b) {
      if ((set >> b & 1) != 0) continue;
      int64_t& best = least[set | size_t{1} << a | size_t{1} << b];
      best = std::min(best, least[set] + costs(static_cast<int32_t>(a), static_cast<int32_t>(b)));
    }
  }
  return least.back();
}

int64_t LengthOf(const Costs& costs, const std::vector<NodePair>& pairs) {
  return std::accumulate(
      pairs.begin(), pairs.end(), int64_t{0},
      [&](int64_t sum, const NodePair& pair) { return sum + costs(pair.a, pair.b); });
}

TEST(Christofides, MatchingIsTheLightest) {
  for (const size_t size : {2, 4, 10, 14}) {
    for (uint32_t seed = 1; seed <= 12; ++seed) {
      const Costs costs = ordering::RandomCosts(size, seed, seed % 2 == 0 ? 1000 : 6);
      Tour nodes(size);
      std::iota(nodes.begin(), nodes.end(), 0);
      EXPECT_EQ(LengthOf(costs, MinimumMatching(costs, nodes)), LightestPairs(costs));
    }
  }
}

// Clusters of odd size are so far apart that no node has a neighbour in another cluster.
TEST(Christofides, MatchingLooksBeyondNeighbours) {
  std::vector<Vector2> points;
  for (const double x : {0.0, 1e5, 3e5, 3.9e5}) {
    for (const Vector2& place : ordering::RandomPlaces(11, 7, 100))
      points.push_back({place.x() + x, place.y()});
  }
  const Costs costs = Costs::OfPoints(points, ordering::Metric::kNearest);
  Tour nodes(points.size());
  std::iota(nodes.begin(), nodes.end(), 0);
  const int64_t length = LengthOf(costs, MinimumMatching(costs, nodes));
  EXPECT_GE(length, 190'000 - 400);
  EXPECT_LE(length, 190'000 + 2000);
}

TEST(Christofides, OfNoNodes) {
  EXPECT_TRUE(MinimumMatching(ordering::RandomCosts(3, 1), {}).empty());
}

TEST(Christofides, AtMostHalfAsMuchAgainAsTheShortest) {
  for (size_t size = 1; size <= 10; ++size) {
    for (uint32_t seed = 1; seed <= 20; ++seed) {
      // Rounding up preserves the triangle inequality.
      const Costs costs = Costs::OfPoints(
          ordering::RandomPlaces(size, seed, seed % 3 == 0 ? 5 : 1000), ordering::Metric::kUp);
      const Tour tour = ChristofidesTour(costs);
      ASSERT_TRUE(ordering::Keeps(tour, static_cast<int32_t>(size), {}));
      EXPECT_LE(2 * TourLength(costs, tour), 3 * ordering::ShortestTour(costs));
    }
  }
}

TEST(Christofides, OfTsplib) {
  for (const auto& [name, optimum] : {std::pair("att48", 10628), std::pair("berlin52", 7542),
                                      std::pair("kroA100", 21282), std::pair("d1291", 50801)}) {
    const Costs costs = ordering::CorpusInstance(name).costs;
    const Tour tour = ChristofidesTour(costs);
    ASSERT_TRUE(ordering::Keeps(tour, costs.size(), {}));
    EXPECT_GE(TourLength(costs, tour), optimum);
    EXPECT_LE(static_cast<double>(TourLength(costs, tour)), 1.2 * optimum) << name;
  }
}

}  // namespace
}  // namespace slicefarm::lab::christofides_test
