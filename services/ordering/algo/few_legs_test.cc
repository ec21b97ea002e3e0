#include "services/ordering/algo/few_legs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

namespace slicefarm::ordering::few_legs_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

int64_t Rounded(Point a, Point b) { return static_cast<int64_t>(Distance(a, b) + 0.5); }

/// Returns the distance from a to b, plus 400 if the line crosses x = 0.
int64_t WithFence(Point a, Point b) { return Rounded(a, b) + ((a.x < 0) != (b.x < 0) ? 400 : 0); }

bool Kept(const Journey& journey, std::span<const TourLeg> legs, std::span<const Visit> visits) {
  std::vector<size_t> rank(legs.size());
  for (size_t i = 0; i < visits.size(); ++i) {
    rank[visits[i].leg] = i;
    if (visits[i].reversed && !legs[visits[i].leg].reversible) return false;
  }
  return std::ranges::all_of(
      journey.precedence, [&](const Precedence& pair) { return rank[pair.leg] < rank[pair.next]; });
}

int64_t CostOf(const Journey& journey, std::span<const TourLeg> legs, std::span<const Visit> visits,
               const TravelCost& cost) {
  int64_t sum = 0;
  Point at = journey.from;
  for (const Visit& visit : visits) {
    const TourLeg& leg = legs[visit.leg];
    sum += cost(at, visit.reversed ? leg.end : leg.start);
    at = visit.reversed ? leg.start : leg.end;
  }
  return journey.to ? sum + cost(at, *journey.to) : sum;
}

/// Returns the least cost over all orders and directions.
int64_t Least(const Journey& journey, std::span<const TourLeg> legs, const TravelCost& cost) {
  std::vector<uint32_t> order(legs.size());
  std::iota(order.begin(), order.end(), 0);
  int64_t best = std::numeric_limits<int64_t>::max();
  do {
    for (uint32_t directions = 0; directions < (1U << legs.size()); ++directions) {
      std::vector<Visit> visits;
      for (size_t i = 0; i < legs.size(); ++i)
        visits.push_back({order[i], ((directions >> i) & 1U) != 0});
      if (Kept(journey, legs, visits)) best = std::min(best, CostOf(journey, legs, visits, cost));
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

TEST(FewLegs, None) { EXPECT_THAT(BestOrder({{0, 0}, {}}, {}, Rounded), IsEmpty()); }

TEST(FewLegs, OfEqualsOneIsTaken) {
  const std::vector<TourLeg> legs(kFewLegs, TourLeg{{5, 5}, {5, 5}});
  const auto visits = BestOrder({{5, 5}, {}}, legs, Rounded);
  EXPECT_EQ(visits.size(), kFewLegs);
  EXPECT_EQ(visits, BestOrder({{5, 5}, {}}, legs, Rounded));
}

TEST(FewLegs, KeepsPrecedence) {
  const std::vector<TourLeg> legs = {{{10, 0}, {10, 0}}, {{20, 0}, {20, 0}}};
  const std::vector<Precedence> second_first = {{1, 0}};
  EXPECT_THAT(BestOrder({{0, 0}, {}, nullptr, second_first}, legs, Rounded),
              ElementsAre(Visit{1, false}, Visit{0, false}));
}

TEST(FewLegs, IsTheBestOfAllOrders) {
  std::mt19937 random(4);
  const auto point = [&random] {
    return Point{static_cast<Coord>(random() % 2000) - 1000, static_cast<Coord>(random() % 2000)};
  };
  for (int set = 0; set < 150; ++set) {
    // Two of the sets have six legs, which means 46080 orders and directions.
    const size_t count = set % 40 == 39 ? 6 : 1 + static_cast<size_t>(set) % 5;
    std::vector<TourLeg> legs;
    for (size_t i = 0; i < count; ++i) legs.push_back({point(), point(), random() % 4 != 0});
    std::vector<Precedence> precedence;
    for (uint32_t i = 0; i + 1 < count; ++i)
      if (random() % 3 == 0) precedence.push_back({i + 1, i});
    Journey journey{point(), {}, nullptr, precedence};
    if (set % 2 == 0) journey.to = point();
    for (const TravelCost& cost : {TravelCost(Rounded), TravelCost(WithFence)}) {
      const auto visits = BestOrder(journey, legs, cost);
      ASSERT_EQ(visits.size(), count);
      ASSERT_TRUE(Kept(journey, legs, visits));
      ASSERT_EQ(CostOf(journey, legs, visits, cost), Least(journey, legs, cost)) << "set " << set;
    }
  }
}

}  // namespace
}  // namespace slicefarm::ordering::few_legs_test
