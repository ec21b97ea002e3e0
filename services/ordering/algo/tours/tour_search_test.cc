#include "services/ordering/algo/tours/tour_search.h"

#include <gtest/gtest.h>

#include <numeric>

#include "services/ordering/algo/tours/constructions.h"
#include "services/ordering/algo/tours/exact_tour_test.h"

namespace slicefarm::ordering::tour_search_test {
namespace {

constexpr int64_t kPlenty = std::numeric_limits<int64_t>::max();

Tour InOrder(int32_t size) {
  Tour tour(static_cast<size_t>(size));
  std::iota(tour.begin(), tour.end(), 0);
  return tour;
}

struct Search {
  SearchDepth depth = SearchDepth::kChains;
  int64_t exchanges = 200;
  uint32_t seed = 1;
  int64_t moves = kPlenty;
};

Tour Improved(const Costs& costs, const TourRules& rules, const Tour& tour, const Search& how) {
  const Neighbours neighbours(costs, 5, 3);
  TourSearch search(costs, neighbours, rules, tour, how.depth, how.seed);
  WorkBudget budget{how.moves};
  search.Improve(budget);
  search.Iterate(how.exchanges, budget);
  EXPECT_TRUE(Keeps(search.tour(), costs.size(), rules));
  EXPECT_EQ(TourLength(costs, tour) - search.gained(), TourLength(costs, search.tour()));
  return search.tour();
}

int64_t ImprovedLength(const Costs& costs, const Search& how) {
  return TourLength(costs, Improved(costs, {}, InOrder(costs.size()), how));
}

class DepthTest : public testing::TestWithParam<SearchDepth> {};

TEST_P(DepthTest, FindsTheShortestOfSmallOnes) {
  int exact = 0;
  int all = 0;
  for (size_t size = 1; size <= 12; ++size) {
    for (uint32_t seed = 1; seed <= 10; ++seed) {
      const Costs costs = RandomCosts(size, seed, seed % 4 == 0 ? 4 : 1000);
      const int64_t length = ImprovedLength(costs, {.depth = GetParam()});
      const int64_t optimum = ShortestTour(costs);
      ASSERT_GE(length, optimum);
      exact += length == optimum;
      ++all;
    }
  }
  EXPECT_GE(exact, all - 2);
}

// Random fixed edges and orders: starting from a tour that keeps them, every depth keeps them and
// finds a tour near the best.
TEST_P(DepthTest, KeepsTheRules) {
  int64_t lengths = 0;
  int64_t starts = 0;
  for (uint32_t seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const auto size = static_cast<int32_t>(4 + random() % 40);
    Costs costs = RandomCosts(static_cast<size_t>(size), seed);
    Tour tour = InOrder(size);
    TourRules rules{.fixed = {{size - 1, 0}}, .before = {}, .first = 0, .last = size - 1};
    for (int32_t node = 0; node + 2 < size; ++node) {
      if (random() % 4 == 0) rules.fixed.push_back({node, node + 1});
      const auto later = node + 1 + static_cast<int32_t>(random() % 3);
      if (random() % 3 == 0 && later < size - 1) rules.before.push_back({node, later});
    }
    if (seed % 2 == 0) std::ranges::reverse(tour);
    starts += TourLength(costs, tour);
    lengths += TourLength(costs, Improved(costs, rules, tour, {.depth = GetParam()}));
  }
  EXPECT_LT(lengths, starts * 8 / 10);
}

TEST_P(DepthTest, IsTheSameForASeed) {
  const Costs costs = RandomCosts(150, 9);
  const Search how{.depth = GetParam(), .exchanges = 300, .seed = 5};
  EXPECT_EQ(Improved(costs, {}, InOrder(150), how), Improved(costs, {}, InOrder(150), how));
  Search other = how;
  other.seed = 6;
  EXPECT_NE(Improved(costs, {}, InOrder(150), how), Improved(costs, {}, InOrder(150), other));
}

std::string NameOf(const testing::TestParamInfo<SearchDepth>& info) {
  const std::array<std::string, 4> names = {"None", "TwoOpt", "ThreeOpt", "Chains"};
  return names[static_cast<size_t>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(TourSearch, DepthTest,
                         testing::Values(SearchDepth::kTwoOptAndOrOpt, SearchDepth::kThreeOpt,
                                         SearchDepth::kChains),
                         NameOf);

// On a grid with even sides the shortest tour has as many edges of length one as nodes. The search
// finds it for any rotation, mirroring, shift, numbering and scale of the grid.
TEST(TourSearch, FindsTheSameHoweverThePlacesLie) {
  using Transform = Vector2 (*)(Vector2);
  const std::vector<Transform> transforms = {[](Vector2 p) { return p; },
                                             [](Vector2 p) {
                                               return Vector2{-p.y(), p.x()};
                                             },
                                             [](Vector2 p) {
                                               return Vector2{-p.x(), p.y()};
                                             },
                                             [](Vector2 p) {
                                               return Vector2{p.x() + 1e6, p.y() - 3e5};
                                             },
                                             [](Vector2 p) {
                                               return Vector2{1000 * p.x(), 1000 * p.y()};
                                             }};
  std::mt19937 random(2);
  for (size_t i = 0; i < transforms.size(); ++i) {
    std::vector<Vector2> points;
    for (int x = 0; x < 6; ++x)
      for (int y = 0; y < 5; ++y) points.push_back(transforms[i]({10.0 * x, 10.0 * y}));
    for (size_t k = points.size() - 1; k > 0; --k) std::swap(points[k], points[random() % (k + 1)]);
    const int64_t unit = i == 4 ? 10'000 : 10;
    EXPECT_EQ(ImprovedLength(Costs::OfPoints(points, Metric::kNearest), {.exchanges = 2000}),
              30 * unit)
        << "transform " << i;
  }
}

TEST(TourSearch, ShallowMovesFindWhatTheyAreNamedFor) {
  // A section in the wrong direction.
  const Costs turned = Costs::OfPoints({{0, 0}, {20, 0}, {10, 0}, {30, 0}, {15, 30}}, Metric::kUp);
  EXPECT_EQ(ImprovedLength(turned, {.depth = SearchDepth::kTwoOptAndOrOpt, .exchanges = 0}),
            ShortestTour(turned));
  // Without moves the tour does not change.
  EXPECT_EQ(ImprovedLength(turned, {.depth = SearchDepth::kNone, .exchanges = 0}),
            TourLength(turned, {0, 1, 2, 3, 4}));
}

TEST(TourSearch, MoreMovesAreNeverWorse) {
  const Costs costs = RandomCosts(300, 4);
  int64_t before = TourLength(costs, InOrder(300));
  for (const int64_t moves : {0, 100, 3000, 30'000, 300'000}) {
    const int64_t length = ImprovedLength(costs, {.exchanges = 10'000, .moves = moves});
    EXPECT_LE(length, before) << moves;
    before = length;
  }
}

TEST(TourSearch, TheBudgetEnds) {
  const Costs costs = RandomCosts(300, 4);
  const Neighbours neighbours(costs, 8, 0);
  const TourRules none;
  TourSearch search(costs, neighbours, none, InOrder(300), SearchDepth::kChains, 1);
  WorkBudget budget{20'000};
  search.Improve(budget);
  search.Iterate(kPlenty, budget);
  EXPECT_LE(budget.moves, 0);
  EXPECT_GT(budget.moves, -2000);
}

/// Surcharge for edges between even and odd nodes.
class Parity : public Surcharge {
 public:
  int64_t Of(int32_t a, int32_t b) const override { return (a + b) % 2 == 0 ? 0 : 100'000; }
};

TEST(TourSearch, PaysSurchargesOnlyWhereItMust) {
  const Costs costs = RandomCosts(40, 6);
  const Neighbours neighbours(costs, 39, 0);
  const TourRules none;
  TourSearch search(costs, neighbours, none, InOrder(40), SearchDepth::kChains, 1);
  WorkBudget budget{kPlenty};
  search.Improve(budget);
  const Parity parity;
  const auto changes = [&search] {
    int count = 0;
    for (size_t i = 0; i < 40; ++i)
      count += (search.tour()[i] + search.tour()[(i + 1) % 40]) % 2 == 0 ? 0 : 1;
    return count;
  };
  EXPECT_GT(changes(), 4);
  search.Charge(&parity);
  for (const int32_t node : Tour(search.tour())) search.Wake(node);
  search.Improve(budget);
  search.Iterate(500, budget);
  EXPECT_EQ(changes(), 2);
  EXPECT_TRUE(Keeps(search.tour(), 40, none));
}

struct GapCase {
  const char* name;
  int64_t optimum;  ///< length without the fixed edges
  int64_t fixed_length;
  double gap;
};

class GapTest : public testing::TestWithParam<GapCase> {};

TEST_P(GapTest, OfTsplib) {
  const TspInstance instance = CorpusInstance(GetParam().name);
  const Costs& costs = instance.costs;
  const TourRules rules{.fixed = instance.fixed, .before = {}};
  const Tour greedy = GreedyEdgeTour(costs, Neighbours(costs, 5, 3), instance.fixed);
  const auto gap = [&](const Search& how) {
    const auto length = static_cast<double>(TourLength(costs, Improved(costs, rules, greedy, how)) -
                                            GetParam().fixed_length);
    return length / static_cast<double>(GetParam().optimum) - 1;
  };
  const double shallow = gap({.depth = SearchDepth::kTwoOptAndOrOpt, .exchanges = 0});
  EXPECT_GE(shallow, 0);
  EXPECT_LE(shallow, 0.07);
  const double deep = gap({.exchanges = 6000});
  EXPECT_GE(deep, 0);
  EXPECT_LE(deep, GetParam().gap);
}

INSTANTIATE_TEST_SUITE_P(
    TourSearch, GapTest,
    testing::Values(GapCase{"att48", 10628, 0, 0.001}, GapCase{"berlin52", 7542, 0, 0.0},
                    GapCase{"eil51", 426, 0, 0.0}, GapCase{"kroA100", 21282, 0, 0.0},
                    GapCase{"linhp318", 41345, 3869, 0.005}, GapCase{"d1291", 50801, 0, 0.02}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace slicefarm::ordering::tour_search_test
