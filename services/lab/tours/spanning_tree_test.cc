#include "services/lab/tours/spanning_tree.h"

#include <gtest/gtest.h>

#include <numeric>
#include <tuple>

#include "services/ordering/algo/tours/exact_tour_test.h"

namespace slicefarm::lab::spanning_tree_test {
namespace {

using ordering::Costs;
using ordering::NodePair;

/// Returns the length of the shortest tree, by Kruskal's algorithm.
int64_t TreeLength(const Costs& costs) {
  std::vector<std::tuple<int64_t, int32_t, int32_t>> edges;
  for (int32_t a = 0; a < costs.size(); ++a)
    for (int32_t b = 0; b < a; ++b) edges.emplace_back(costs(a, b), a, b);
  std::ranges::sort(edges);
  std::vector<int32_t> group(static_cast<size_t>(costs.size()));
  std::iota(group.begin(), group.end(), 0);
  int64_t sum = 0;
  for (const auto& [length, a, b] : edges) {
    const int32_t from = group[static_cast<size_t>(a)];
    const int32_t to = group[static_cast<size_t>(b)];
    if (from == to) continue;
    std::ranges::replace(group, from, to);
    sum += length;
  }
  return sum;
}

TEST(SpanningTree, IsTheShortest) {
  for (const size_t size : {1, 2, 3, 30}) {
    for (const int range : {1, 8, 1000}) {
      const Costs costs = ordering::RandomCosts(size, 3, range);
      const SpanningTree tree = MinimumSpanningTree(costs);
      EXPECT_EQ(tree.edges.size(), size - 1);
      EXPECT_EQ(tree.length, TreeLength(costs));
    }
  }
}

// Lengths of minimum spanning trees computed by another program.
TEST(SpanningTree, OfTsplib) {
  EXPECT_EQ(MinimumSpanningTree(ordering::CorpusInstance("att48").costs).length, 8767);
  EXPECT_EQ(MinimumSpanningTree(ordering::CorpusInstance("berlin52").costs).length, 6078);
  EXPECT_EQ(MinimumSpanningTree(ordering::CorpusInstance("eil51").costs).length, 375);
  EXPECT_EQ(MinimumSpanningTree(ordering::CorpusInstance("kroA100").costs).length, 18772);
}

TEST(OneTreeBound, IsBelowEveryTour) {
  double bounds = 0;
  double optima = 0;
  for (size_t size = 1; size <= 10; ++size) {
    for (uint32_t seed = 1; seed <= 10; ++seed) {
      const Costs costs = ordering::RandomCosts(size, seed, seed % 3 == 0 ? 5 : 1000);
      const int64_t optimum = ordering::ShortestTour(costs);
      const int64_t bound = OneTreeBound(costs, {}, {.iterations = 60, .upper_bound = optimum});
      ASSERT_LE(bound, optimum) << size << " nodes, seed " << seed;
      bounds += static_cast<double>(bound);
      optima += static_cast<double>(optimum);
    }
  }
  EXPECT_GE(bounds, 0.985 * optima);
}

TEST(OneTreeBound, CountsFixedEdges) {
  double bounds = 0;
  double optima = 0;
  for (uint32_t seed = 1; seed <= 20; ++seed) {
    const Costs costs = ordering::RandomCosts(9, seed);
    const std::vector<NodePair> fixed = {{0, 8}, {3, 5}, {5, 1}};
    // Each edge that is not fixed costs so much more that every best tour contains all fixed edges.
    const ordering::FixedEdges edges(9, fixed);
    std::vector<int32_t> table;
    constexpr int32_t kAway = 100'000;
    for (int32_t a = 0; a < 9; ++a) {
      for (int32_t b = 0; b < 9; ++b)
        table.push_back(static_cast<int32_t>(costs(a, b)) + (edges.Has(a, b) ? 0 : kAway));
    }
    const int64_t optimum = ordering::ShortestTour(Costs::OfTable(9, table)) - 6 * kAway;
    const int64_t bound = OneTreeBound(costs, fixed, {.iterations = 60, .upper_bound = optimum});
    ASSERT_LE(bound, optimum) << "seed " << seed;
    ASSERT_GE(bound, OneTreeBound(costs, {}, {.iterations = 1, .upper_bound = optimum}));
    bounds += static_cast<double>(bound);
    optima += static_cast<double>(optimum);
  }
  EXPECT_GE(bounds, 0.96 * optima);
}

TEST(OneTreeBound, OfTsplib) {
  for (const auto& [name, optimum] : {std::pair("att48", 10628), std::pair("berlin52", 7542),
                                      std::pair("eil51", 426), std::pair("kroA100", 21282)}) {
    const int64_t bound = OneTreeBound(ordering::CorpusInstance(name).costs, {},
                                       {.iterations = 150, .upper_bound = optimum});
    EXPECT_LE(bound, optimum) << name;
    EXPECT_GE(static_cast<double>(bound), 0.98 * optimum) << name;
  }
}

}  // namespace
}  // namespace slicefarm::lab::spanning_tree_test
