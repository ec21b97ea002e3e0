#include "services/ordering/algo/tour_improvement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::ordering {
namespace {

using ::testing::ElementsAre;

Leg Line(Coord x0, Coord y0, Coord x1, Coord y1) {
  return {{x0 * kNmPerMm, y0 * kNmPerMm}, {x1 * kNmPerMm, y1 * kNmPerMm}};
}

Leg Dot(Coord x, Coord y) { return Line(x, y, x, y); }

std::vector<Visit> Improved(const Journey& journey, const std::vector<Leg>& legs,
                            std::vector<Visit> visits) {
  TourImprovement tour(journey, legs, std::move(visits));
  WorkBudget budget{100'000};
  tour.Improve(budget);
  return tour.visits();
}

TEST(TourImprovement, TurnsARunRound) {
  // 0 - 2 - 1 - 3 on a line crosses itself.
  const std::vector<Leg> legs = {Dot(1, 0), Dot(2, 0), Dot(3, 0), Dot(4, 0), Dot(5, 0)};
  const auto visits =
      Improved({{0, 0}, {}}, legs, {{0, false}, {3, false}, {2, false}, {1, false}, {4, false}});
  EXPECT_EQ(TravelLength({{0, 0}, {}}, legs, visits), 5 * kNmPerMm);
}

TEST(TourImprovement, TurnsASingleLeg) {
  const std::vector<Leg> legs = {Line(9, 0, 1, 0), Line(10, 1, 2, 1)};
  EXPECT_THAT(Improved({{0, 0}, {}}, legs, {{0, false}, {1, false}}),
              ElementsAre(Visit{0, true}, Visit{1, false}));
}

TEST(TourImprovement, ShiftsALegThatMayNotBeTurned) {
  std::vector<Leg> legs = {Line(1, 0, 2, 0), Line(3, 0, 4, 0), Line(5, 0, 6, 0)};
  for (Leg& leg : legs) leg.reversible = false;
  EXPECT_THAT(Improved({{0, 0}, {}}, legs, {{1, false}, {2, false}, {0, false}}),
              ElementsAre(Visit{0, false}, Visit{1, false}, Visit{2, false}));
}

TEST(TourImprovement, TurnsNoRunWithALegThatMayNotBeTurned) {
  std::vector<Leg> legs = {Line(9, 0, 1, 0)};
  legs[0].reversible = false;
  EXPECT_THAT(Improved({{0, 0}, {}}, legs, {{0, false}}), ElementsAre(Visit{0, false}));
}

TEST(TourImprovement, WorksTowardsTheGoal) {
  const std::vector<Leg> legs = {Dot(1, 0), Dot(9, 0)};
  EXPECT_THAT(Improved({{5 * kNmPerMm, 0}, Point{0, 0}}, legs, {{0, false}, {1, false}}),
              ElementsAre(testing::Field(&Visit::leg, 1), testing::Field(&Visit::leg, 0)));
}

/// Between negative and other x.
class Fence : public Barrier {
 public:
  bool Parts(Point a, Point b) const override { return (a.x < 0) != (b.x < 0); }
};

int Crossings(const Journey& journey, const std::vector<Leg>& legs,
              const std::vector<Visit>& visits) {
  int crossings = 0;
  Point at = journey.from;
  for (const Visit& visit : visits) {
    const Leg& leg = legs[visit.leg];
    crossings += Fence().Parts(at, visit.reversed ? leg.end : leg.start) ? 1 : 0;
    at = visit.reversed ? leg.start : leg.end;
  }
  return crossings;
}

// Pairs of dots, nearer to each other than to the next pair: the shortest way goes to and fro.
TEST(TourImprovement, CrossesABarrierOnlyWhereItMust) {
  std::vector<Leg> legs;
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

// A way round that costs more than a crossing is not taken.
TEST(TourImprovement, CrossesABarrierWhereItPays) {
  const std::vector<Leg> legs = {Dot(-1, 0), Dot(1, 0), Dot(-1, 20), Dot(1, 20)};
  const Fence fence;
  const Journey journey{{-kNmPerMm, 0}, Point{-kNmPerMm, 40 * kNmPerMm}, &fence};
  WorkBudget budget{100'000};
  EXPECT_EQ(Crossings(journey, legs, OrderByTravel(journey, legs, budget)), 2);
}

TEST(TourImprovement, ABarrierThatIsNotMetChangesNothing) {
  const std::vector<Leg> legs = {Dot(9, 0), Dot(4, 7), Dot(2, 2), Dot(6, 1), Dot(7, 8)};
  const Fence fence;
  Journey journey{{0, 0}, {}};
  WorkBudget budget{100'000};
  const auto plain = OrderByTravel(journey, legs, budget);
  journey.barrier = &fence;
  EXPECT_EQ(OrderByTravel(journey, legs, budget), plain);
}

TEST(TourImprovement, WithoutBudgetNothingChanges) {
  const std::vector<Leg> legs = {Dot(3, 0), Dot(1, 0)};
  TourImprovement tour({{0, 0}, {}}, legs, {{0, false}, {1, true}});
  WorkBudget none{0};
  tour.Improve(none);
  EXPECT_THAT(tour.visits(), ElementsAre(Visit{0, false}, Visit{1, true}));
}

}  // namespace
}  // namespace slicefarm::ordering
