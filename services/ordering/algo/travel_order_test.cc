#include "services/ordering/algo/travel_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <numeric>
#include <random>
#include <string>

namespace slicefarm::ordering::travel_order_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr int64_t kPlenty = 10'000'000;

std::vector<Visit> Order(const Journey& journey, std::span<const TourLeg> legs,
                         int64_t moves = kPlenty) {
  WorkBudget budget{moves};
  return OrderByTravel(journey, legs, budget);
}

TourLeg RandomLeg(std::mt19937& random, bool reversible = true) {
  std::uniform_int_distribution<Coord> coord(0, 100 * kNmPerMm);
  return {{coord(random), coord(random)}, {coord(random), coord(random)}, reversible};
}

std::vector<TourLeg> RandomLegs(size_t count, uint32_t seed, int irreversible_of_4 = 0) {
  std::mt19937 random(seed);
  std::vector<TourLeg> legs;
  for (size_t i = 0; i < count; ++i) {
    legs.push_back(RandomLeg(random, static_cast<int>(random() % 4) >= irreversible_of_4));
  }
  return legs;
}

void ExpectEachLegOnce(const std::vector<Visit>& visits, std::span<const TourLeg> legs) {
  ASSERT_EQ(visits.size(), legs.size());
  std::vector<int> seen(legs.size(), 0);
  for (const Visit& visit : visits) {
    ASSERT_LT(visit.leg, legs.size());
    ++seen[visit.leg];
    EXPECT_TRUE(legs[visit.leg].reversible || !visit.reversed);
  }
  EXPECT_THAT(seen, testing::Each(1));
}

/// Returns the least travel over all orders and directions.
double Optimum(const Journey& journey, std::span<const TourLeg> legs) {
  std::vector<uint32_t> order(legs.size());
  std::iota(order.begin(), order.end(), 0);
  double best = std::numeric_limits<double>::infinity();
  do {
    for (uint32_t directions = 0; directions < (1U << legs.size()); ++directions) {
      std::vector<Visit> visits;
      bool allowed = true;
      for (size_t i = 0; i < legs.size(); ++i) {
        const bool reversed = ((directions >> i) & 1U) != 0;
        allowed = allowed && (!reversed || legs[order[i]].reversible);
        visits.push_back({order[i], reversed});
      }
      if (allowed) best = std::min(best, TravelLength(journey, legs, visits));
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

TEST(TravelOrder, NothingToVisit) {
  EXPECT_THAT(Order({{0, 0}, Point{5, 5}}, {}), IsEmpty());
  EXPECT_EQ(TravelLength({{0, 0}, Point{3, 4}}, {}, {}), 5);
}

TEST(TravelOrder, OneLegIsEnteredAtItsNearEnd) {
  const TourLeg leg{{100, 0}, {10, 0}};
  EXPECT_THAT(Order({{0, 0}, {}}, {{leg}}), ElementsAre(Visit{0, true}));
  EXPECT_THAT(Order({{0, 0}, {}}, {{{leg.start, leg.end, false}}}), ElementsAre(Visit{0, false}));
}

TEST(TravelOrder, TheWayOnDecidesToo) {
  // If the leg begins at its near end, it ends far from the target of the journey.
  const TourLeg leg{{10'000, 0}, {100'000, 0}};
  EXPECT_THAT(Order({{0, 0}, {}}, {{leg}}), ElementsAre(Visit{0, false}));
  EXPECT_THAT(Order({{0, 0}, Point{0, 5}}, {{leg}}), testing::SizeIs(1));
  const TourLeg far{{60'000, 0}, {100'000, 0}};
  EXPECT_THAT(Order({{70'000, 0}, Point{50'000, 0}}, {{far}}), ElementsAre(Visit{0, true}));
}

TEST(TravelOrder, ParallelLinesBecomeAZigzag) {
  std::vector<TourLeg> legs;
  for (const Coord y : {3, 0, 4, 1, 2}) {
    legs.push_back({{0, y * kNmPerMm}, {50 * kNmPerMm, y * kNmPerMm}});
  }
  EXPECT_THAT(Order({{0, 0}, {}}, legs),
              ElementsAre(Visit{1, false}, Visit{3, true}, Visit{4, false}, Visit{0, true},
                          Visit{2, false}));
}

TEST(TravelOrder, FindsTheOptimumOfSmallSets) {
  for (int set = 0; set < 60; ++set) {
    const size_t count = 2 + static_cast<size_t>(set) % 5;
    const auto legs = RandomLegs(count, static_cast<uint32_t>(set), set % 3);
    Journey journey{{50 * kNmPerMm, 0}, {}};
    if (set % 2 == 1) journey.to = Point{0, 70 * kNmPerMm};
    const double length = TravelLength(journey, legs, Order(journey, legs));
    EXPECT_NEAR(length, Optimum(journey, legs), 10) << "set " << set;  // rounding to nm
  }
}

std::vector<Point> ReadTsplib(const std::string& name) {
  std::ifstream in(std::string(SLICEFARM_CORPUS) + "/tsplib/" + name + ".tsp");
  std::string word;
  while (in >> word && word != "NODE_COORD_SECTION") {
  }
  std::vector<Point> cities;
  int number = 0;
  double x = 0;
  double y = 0;
  while (in >> number >> x >> y) cities.push_back({FromMm(x), FromMm(y)});
  return cities;
}

struct TsplibCase {
  std::string name;
  int64_t optimum;
};

class TsplibTest : public testing::TestWithParam<TsplibCase> {};

// Cities are legs without length. A tour is a journey from the first city back to the first city.
TEST_P(TsplibTest, TourIsWithinSevenPercent) {
  const std::vector<Point> cities = ReadTsplib(GetParam().name);
  ASSERT_FALSE(cities.empty()) << "no corpus";
  std::vector<TourLeg> legs;
  for (size_t i = 1; i < cities.size(); ++i) legs.push_back({cities[i], cities[i]});
  const std::vector<Visit> visits = Order({cities[0], cities[0]}, legs);
  ExpectEachLegOnce(visits, legs);
  int64_t length = 0;  // EUC_2D rounds each distance
  Point at = cities[0];
  for (const Visit& visit : visits) {
    length += std::llround(ToMm(Distance(at, legs[visit.leg].start)));
    at = legs[visit.leg].start;
  }
  length += std::llround(ToMm(Distance(at, cities[0])));
  EXPECT_GE(length, GetParam().optimum);
  EXPECT_LE(static_cast<double>(length), 1.07 * static_cast<double>(GetParam().optimum));
  RecordProperty("length", static_cast<int>(length));
}

INSTANTIATE_TEST_SUITE_P(Tsplib, TsplibTest,
                         testing::Values(TsplibCase{"berlin52", 7542}, TsplibCase{"eil51", 426},
                                         TsplibCase{"kroA100", 21282}),
                         [](const auto& info) { return info.param.name; });

TEST(TravelOrder, LosesNothingAndReversesOnlyWhatItMay) {
  for (const size_t count : {1, 2, 3, 24, 25, 300}) {
    for (const int irreversible : {0, 1, 4}) {
      const auto legs = RandomLegs(count, static_cast<uint32_t>(count), irreversible);
      ExpectEachLegOnce(Order({{0, 0}, {}}, legs), legs);
      ExpectEachLegOnce(Order({{0, 0}, Point{1, 1}}, legs), legs);
    }
  }
}

TEST(TravelOrder, ImprovementShortensNearestNeighbour) {
  const auto legs = RandomLegs(400, 7);
  const Journey journey{{0, 0}, {}};
  const double nearest = TravelLength(journey, legs, Order(journey, legs, 0));
  const double improved = TravelLength(journey, legs, Order(journey, legs));
  EXPECT_LT(improved, 0.93 * nearest);
}

TEST(TravelOrder, MoreWorkIsNeverWorse) {
  const auto legs = RandomLegs(200, 3, 1);
  const Journey journey{{0, 0}, Point{kNmPerMm, 0}};
  double before = std::numeric_limits<double>::infinity();
  for (const int64_t moves : {0, 100, 1'000, 10'000, 100'000}) {
    const double length = TravelLength(journey, legs, Order(journey, legs, moves));
    EXPECT_LE(length, before + 1);
    before = length;
  }
}

TEST(TravelOrder, BudgetIsSharedAndEnds) {
  const auto legs = RandomLegs(200, 5);
  WorkBudget budget{500};
  OrderByTravel({{0, 0}, {}}, legs, budget);
  EXPECT_LE(budget.moves, 0);
}

TourLeg Dot(Coord x_mm, Coord y_mm) {
  const Point at{x_mm * kNmPerMm, y_mm * kNmPerMm};
  return {at, at};
}

std::vector<uint32_t> LegsOf(const std::vector<Visit>& visits) {
  std::vector<uint32_t> legs;
  for (const Visit& visit : visits) legs.push_back(visit.leg);
  return legs;
}

TEST(TravelOrder, WithoutBudgetTheNearestIsNext) {
  const std::vector<TourLeg> legs = {Dot(3, 0), Dot(-2, 0), Dot(1, 0)};
  EXPECT_THAT(LegsOf(Order({{0, 0}, {}}, legs, 0)), ElementsAre(2, 0, 1));
}

/// Barrier between negative and other x.
class Fence : public Barrier {
 public:
  bool Parts(Point a, Point b) const override { return (a.x < 0) != (b.x < 0); }
};

int Crossings(const Journey& journey, const std::vector<TourLeg>& legs,
              const std::vector<Visit>& visits) {
  int crossings = 0;
  Point at = journey.from;
  for (const Visit& visit : visits) {
    const TourLeg& leg = legs[visit.leg];
    crossings += Fence().Parts(at, visit.reversed ? leg.end : leg.start) ? 1 : 0;
    at = visit.reversed ? leg.start : leg.end;
  }
  return crossings;
}

// The dots of a pair are nearer to each other than to the next pair, so that the shortest path
// crosses the barrier at each pair.
TEST(TravelOrder, CrossesABarrierOnlyWhereItMust) {
  std::vector<TourLeg> legs;
  for (Coord y = 0; y < 12; ++y) {
    legs.push_back(Dot(-1, 3 * y));
    legs.push_back(Dot(1, 3 * y));
  }
  const Fence fence;
  Journey journey{{-kNmPerMm, -3 * kNmPerMm}, {}};
  WorkBudget budget{100'000};
  const auto plain = OrderByTravel(journey, legs, budget);
  EXPECT_EQ(Crossings(journey, legs, plain), 12);
  journey.barrier = &fence;
  EXPECT_EQ(Crossings(journey, legs, OrderByTravel(journey, legs, budget)), 1);
}

// A detour that costs more than a crossing is not used.
TEST(TravelOrder, CrossesABarrierWhereItPays) {
  const std::vector<TourLeg> legs = {Dot(-1, 0), Dot(1, 0), Dot(-1, 20), Dot(1, 20)};
  const Fence fence;
  const Journey journey{{-kNmPerMm, 0}, Point{-kNmPerMm, 40 * kNmPerMm}, &fence};
  WorkBudget budget{100'000};
  EXPECT_EQ(Crossings(journey, legs, OrderByTravel(journey, legs, budget)), 2);
}

TEST(TravelOrder, ABarrierThatIsNotMetChangesNothing) {
  const std::vector<TourLeg> legs = {Dot(9, 0), Dot(4, 7), Dot(2, 2), Dot(6, 1), Dot(7, 8)};
  const Fence fence;
  Journey journey{{0, 0}, {}};
  WorkBudget budget{100'000};
  const auto plain = OrderByTravel(journey, legs, budget);
  journey.barrier = &fence;
  EXPECT_EQ(OrderByTravel(journey, legs, budget), plain);
}

/// Returns the length of the shortest path along dots in an order that keeps the precedence, over
/// all sets of dots.
double BestOfDots(const Journey& journey, std::span<const TourLeg> dots) {
  std::vector<size_t> before(dots.size(), 0);
  for (const Precedence& pair : journey.precedence) before[pair.next] |= size_t{1} << pair.leg;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<std::vector<double>> least(size_t{1} << dots.size(),
                                         std::vector<double>(dots.size(), kFar));
  for (size_t done = 1; done < least.size(); ++done) {
    for (size_t last = 0; last < dots.size(); ++last) {
      const size_t others = done & ~(size_t{1} << last);
      if (others == done || (before[last] & ~others) != 0) continue;
      double& best = least[done][last];
      if (others == 0) best = Distance(journey.from, dots[last].start);
      for (size_t dot = 0; dot < dots.size(); ++dot)
        best = std::min(best, least[others][dot] + Distance(dots[dot].start, dots[last].start));
    }
  }
  return std::ranges::min(least.back());
}

TEST(TravelOrder, KeepsPrecedenceAndComesNearTheBest) {
  double found = 0;
  double optimum = 0;
  for (uint32_t seed = 1; seed <= 80; ++seed) {
    std::mt19937 random(seed);
    const size_t count = 2 + seed % 9;
    std::vector<TourLeg> dots;
    for (size_t i = 0; i < count; ++i)
      dots.push_back(Dot(static_cast<Coord>(random() % 100), static_cast<Coord>(random() % 100)));
    std::vector<Precedence> precedence;
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t next = i + 1 + random() % 4;
      if (next < count && random() % 2 == 0) precedence.push_back({i, next});
    }
    const Journey journey{{0, 0}, {}, nullptr, precedence};
    const std::vector<Visit> visits = Order(journey, dots);
    ExpectEachLegOnce(visits, dots);
    std::vector<size_t> rank(count);
    for (size_t i = 0; i < count; ++i) rank[visits[i].leg] = i;
    for (const Precedence& pair : precedence) ASSERT_LT(rank[pair.leg], rank[pair.next]);
    const double best = BestOfDots(journey, dots);
    const double length = TravelLength(journey, dots, visits);
    EXPECT_GE(length, best - count) << "seed " << seed;
    EXPECT_LE(length, 1.2 * best) << "seed " << seed;
    found += length;
    optimum += best;
  }
  EXPECT_LE(found, 1.01 * optimum);
}

TEST(TravelOrder, NearestNeighbourKeepsPrecedence) {
  const std::vector<TourLeg> legs = {Dot(1, 0), Dot(2, 0), Dot(3, 0)};
  const std::vector<Precedence> precedence = {{2, 0}, {1, 0}};
  EXPECT_THAT(LegsOf(Order({{0, 0}, {}, nullptr, precedence}, legs, 0)), ElementsAre(1, 2, 0));
}

TEST(TravelOrder, AllEndsInOnePoint) {
  const std::vector<TourLeg> legs(5000, TourLeg{{7, 7}, {7, 7}});
  const auto visits = Order({{7, 7}, {}}, legs);
  ExpectEachLegOnce(visits, legs);
  EXPECT_EQ(TravelLength({{7, 7}, {}}, legs, visits), 0);
}

}  // namespace
}  // namespace slicefarm::ordering::travel_order_test
