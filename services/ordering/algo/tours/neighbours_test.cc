#include "services/ordering/algo/tours/neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "services/ordering/algo/tours/exact_tour_test.h"

namespace slicefarm::ordering::neighbours_test {
namespace {

std::vector<int64_t> LengthsOf(std::span<const Neighbour> neighbours) {
  std::vector<int64_t> lengths;
  for (const Neighbour& near : neighbours) lengths.push_back(near.length);
  return lengths;
}

std::vector<int64_t> NearestLengths(const Costs& costs, int32_t node, size_t count) {
  std::vector<int64_t> lengths;
  for (int32_t other = 0; other < costs.size(); ++other) {
    if (other != node && !costs.IsNowhere(other)) lengths.push_back(costs(node, other));
  }
  std::ranges::sort(lengths);
  lengths.resize(std::min(count, lengths.size()));
  return lengths;
}

Costs TableOf(const Costs& costs) {
  std::vector<int32_t> table;
  for (int32_t a = 0; a < costs.size(); ++a) {
    for (int32_t b = 0; b < costs.size(); ++b) table.push_back(static_cast<int32_t>(costs(a, b)));
  }
  return Costs::OfTable(costs.size(), std::move(table));
}

TEST(Neighbours, AreTheNearestOfPlacesAndTables) {
  const Costs points = RandomCosts(60, 1, 40);  // a small range, so that some points are equal
  for (const Costs& costs : {points, TableOf(points)}) {
    const Neighbours neighbours(costs, 7, 0);
    for (int32_t node = 0; node < costs.size(); ++node) {
      EXPECT_EQ(LengthsOf(neighbours.Of(node)), NearestLengths(costs, node, 7));
      for (const Neighbour& near : neighbours.Of(node)) EXPECT_NE(near.node, node);
    }
  }
}

TEST(Neighbours, FewNodesHaveFewNeighbours) {
  EXPECT_TRUE(Neighbours(RandomCosts(1, 1), 5, 1).Of(0).empty());
  EXPECT_EQ(Neighbours(RandomCosts(3, 1), 5, 1).Of(0).size(), 2);
}

TEST(Neighbours, NowhereIsEverybodysFirst) {
  Costs costs = RandomCosts(9, 2);
  const int32_t nowhere = costs.AddNowhere();
  const Neighbours neighbours(costs, 3, 0);
  EXPECT_TRUE(neighbours.Of(nowhere).empty());
  for (int32_t node = 0; node < nowhere; ++node) {
    ASSERT_EQ(neighbours.Of(node).size(), 4);
    EXPECT_EQ(neighbours.Of(node)[0].node, nowhere);
  }
}

// Two clusters: without the quadrants, no node would have a neighbour in the other cluster.
TEST(Neighbours, OfEachQuadrant) {
  std::vector<Vector2> points = RandomPlaces(20, 3, 10);
  for (const Vector2& place : RandomPlaces(20, 4, 10))
    points.push_back({place.x() + 1e6, place.y()});
  const Costs costs = Costs::OfPoints(points, Metric::kNearest);
  const auto far_ones = [&](const Neighbours& neighbours) {
    return std::ranges::count_if(neighbours.Of(0),
                                 [](const Neighbour& near) { return near.node >= 20; });
  };
  EXPECT_EQ(far_ones(Neighbours(costs, 8, 0)), 0);
  Vector2& first = points[0];
  first = {20, 5};  // to the right of its cluster
  const Neighbours neighbours(Costs::OfPoints(points, Metric::kNearest), 8, 1);
  EXPECT_GE(far_ones(neighbours), 1);
  const std::vector<int64_t> lengths = LengthsOf(neighbours.Of(0));
  EXPECT_TRUE(std::ranges::is_sorted(lengths));
}

}  // namespace
}  // namespace slicefarm::ordering::neighbours_test
