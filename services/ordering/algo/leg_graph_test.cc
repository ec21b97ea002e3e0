#include "services/ordering/algo/leg_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace slicefarm::ordering::leg_graph_test {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;

// A line, a point, and a line that may not be reversed.
const std::vector<TourLeg> kLegs = {
    {{0, 0}, {10, 0}, true}, {{5, 5}, {5, 5}, false}, {{20, 0}, {30, 0}, false}};

TEST(LegGraph, JoinsEndsAndTheJourney) {
  const LegGraph graph({{1, 1}, Point{2, 2}}, kLegs);
  EXPECT_EQ(graph.costs().size(), 7);
  EXPECT_THAT(graph.rules().fixed, ElementsAre(NodePair{6, 5}, NodePair{0, 1}, NodePair{3, 4}));
  EXPECT_THAT(graph.rules().before, ElementsAre(NodePair{3, 4}));
  EXPECT_EQ(graph.At(4), (Point{30, 0}));
  EXPECT_EQ(graph.At(6), (Point{2, 2}));
  EXPECT_EQ(graph.costs()(0, 4), 30);
}

TEST(LegGraph, WithoutAGoalItEndsNowhere) {
  const LegGraph graph({{1, 1}, {}}, kLegs);
  EXPECT_TRUE(graph.costs().IsNowhere(graph.rules().last));
  EXPECT_EQ(graph.costs()(graph.rules().last, 0), 0);
}

TEST(LegGraph, PrecedenceIsOfLegs) {
  const std::vector<Precedence> precedence = {{2, 1}};
  const LegGraph graph({{1, 1}, {}, nullptr, precedence}, kLegs);
  EXPECT_THAT(graph.rules().before, ElementsAre(NodePair{3, 4}, NodePair{3, 2}));
}

TEST(LegGraph, ToursAreVisitsHoweverTheyLie) {
  const LegGraph graph({{1, 1}, {}}, kLegs);
  const std::vector<Visit> visits = {{2, false}, {0, true}, {1, false}};
  Tour tour = graph.TourOf(visits);
  EXPECT_THAT(tour, ElementsAre(5, 3, 4, 1, 0, 2, 6));
  EXPECT_TRUE(Keeps(tour, 7, graph.rules()));
  for (size_t turn = 0; turn < tour.size(); ++turn) {
    std::rotate(tour.begin(), tour.begin() + 1, tour.end());
    EXPECT_THAT(graph.VisitsOf(tour), ElementsAreArray(visits));
    std::ranges::reverse(tour);
    EXPECT_THAT(graph.VisitsOf(tour), ElementsAreArray(visits));
  }
}

}  // namespace
}  // namespace slicefarm::ordering::leg_graph_test
