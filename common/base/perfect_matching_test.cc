#include "common/base/perfect_matching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>

namespace slicefarm::perfect_matching_test {
namespace {

using Weights = std::vector<std::vector<int64_t>>;

int64_t Lightest(const Weights& weights, std::vector<uint8_t> taken) {
  const auto free = std::ranges::find(taken, 0);
  if (free == taken.end()) return 0;
  const auto a = static_cast<size_t>(free - taken.begin());
  taken[a] = 1;
  int64_t best = std::numeric_limits<int64_t>::max() / 4;
  for (size_t b = a + 1; b < taken.size(); ++b) {
    if (taken[b]) continue;
    taken[b] = 1;
    best = std::min(best, weights[a][b] + Lightest(weights, taken));
    taken[b] = 0;
  }
  return best;
}

Weights RandomWeights(size_t size, uint32_t seed) {
  std::mt19937 random(seed);
  Weights weights(size, std::vector<int64_t>(size, 0));
  for (size_t a = 0; a < size; ++a)
    for (size_t b = 0; b < a; ++b) weights[a][b] = weights[b][a] = random() % 100;
  return weights;
}

std::vector<WeightedEdge> EdgesOf(const Weights& weights) {
  std::vector<WeightedEdge> edges;
  for (size_t a = 0; a < weights.size(); ++a) {
    for (size_t b = a + 1; b < weights.size(); ++b)
      edges.push_back({static_cast<int32_t>(a), static_cast<int32_t>(b), weights[a][b]});
  }
  return edges;
}

int64_t WeightOf(const PerfectMatching& matching, const Weights& weights) {
  int64_t weight = 0;
  for (size_t a = 0; a < weights.size(); ++a) {
    const auto b = static_cast<size_t>(matching.mate[a]);
    EXPECT_NE(a, b);
    EXPECT_EQ(matching.mate[b], static_cast<int32_t>(a));
    if (a < b) weight += weights[a][b];
  }
  return weight;
}

TEST(PerfectMatching, IsTheLightest) {
  for (const size_t size : {2, 4, 6, 8, 10}) {
    for (uint32_t seed = 1; seed <= 20; ++seed) {
      const Weights weights = RandomWeights(size, seed);
      const std::vector<WeightedEdge> edges = EdgesOf(weights);
      const auto matching = LightestPerfectMatching(static_cast<int32_t>(size), edges);
      EXPECT_EQ(WeightOf(matching, weights), Lightest(weights, std::vector<uint8_t>(size, 0)));
      EXPECT_TRUE(
          std::ranges::all_of(edges, [&](const auto& edge) { return matching.Proves(edge); }));
    }
  }
}

// The matching is computed with only a part of the edges. If the proof holds for all other edges,
// the matching is the lightest of the full graph. Otherwise there may be a lighter matching.
TEST(PerfectMatching, TheProofTellsWhetherMoreEdgesMatter) {
  int proved = 0;
  int lighter = 0;
  for (uint32_t seed = 1; seed <= 200; ++seed) {
    const size_t size = 8;
    const Weights weights = RandomWeights(size, seed);
    std::vector<WeightedEdge> edges = EdgesOf(weights);
    std::vector<WeightedEdge> few;
    for (const WeightedEdge& edge : edges) {
      if (edge.weight < 45 || (edge.a % 2 == 0 && edge.b == edge.a + 1)) few.push_back(edge);
    }
    const auto matching = LightestPerfectMatching(8, few);
    const int64_t weight = WeightOf(matching, weights);
    const int64_t best = Lightest(weights, std::vector<uint8_t>(size, 0));
    const bool proves =
        std::ranges::all_of(edges, [&](const auto& edge) { return matching.Proves(edge); });
    ASSERT_TRUE(!proves || weight == best) << "seed " << seed;
    proved += proves;
    lighter += best < weight;
  }
  EXPECT_GT(proved, 20);
  EXPECT_GT(lighter, 5);
}

}  // namespace
}  // namespace slicefarm::perfect_matching_test
