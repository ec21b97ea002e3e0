#include "services/ordering/algo/tours/array_tour.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

namespace slicefarm::ordering::array_tour_test {
namespace {

using ::testing::ElementsAre;

/// Returns the tour's edges, independent of their direction.
std::set<std::pair<int32_t, int32_t>> EdgesOf(const Tour& tour) {
  std::set<std::pair<int32_t, int32_t>> edges;
  for (size_t i = 0; i < tour.size(); ++i)
    edges.insert(std::minmax(tour[i], tour[(i + 1) % tour.size()]));
  return edges;
}

TEST(ArrayTour, NeighboursGoAllAround) {
  const ArrayTour tour({2, 0, 1});
  EXPECT_EQ(tour.Next(1), 2);
  EXPECT_EQ(tour.Previous(2), 1);
  EXPECT_EQ(tour.Next(2), 0);
  EXPECT_EQ(tour.PositionOf(1), 2);
}

TEST(ArrayTour, TurnsAStretch) {
  ArrayTour tour({0, 1, 2, 3, 4, 5});
  tour.Reverse(1, 3);
  EXPECT_THAT(tour.order(), ElementsAre(0, 3, 2, 1, 4, 5));
}

TEST(ArrayTour, TurnsTheRestIfThatIsShorter) {
  ArrayTour tour({0, 1, 2, 3, 4, 5});
  tour.Reverse(1, 5);  // one node is outside: nothing changes
  EXPECT_THAT(tour.order(), ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(ArrayTour, ATurnIsATwoOptMoveAndUndoesItself) {
  std::mt19937 random(3);
  for (const int32_t size : {3, 4, 7, 20}) {
    Tour order(static_cast<size_t>(size));
    std::iota(order.begin(), order.end(), 0);
    ArrayTour tour(order);
    for (int i = 0; i < 200; ++i) {
      const Tour before = tour.order();
      const auto a = static_cast<int32_t>(random() % static_cast<uint32_t>(size));
      const auto b = static_cast<int32_t>(random() % static_cast<uint32_t>(size));
      const int32_t from = tour.Previous(a);
      const int32_t to = tour.Next(b);
      auto expected = EdgesOf(before);
      if (from == b) continue;  // the whole tour
      expected.erase(std::minmax(from, a));
      expected.erase(std::minmax(b, to));
      expected.insert(std::minmax(from, b));
      expected.insert(std::minmax(a, to));
      const Reversal turn = tour.Reverse(a, b);
      ASSERT_EQ(EdgesOf(tour.order()), expected);
      ASSERT_LE(2 * ArrayTour::Length(turn, size), size + 1);
      for (int32_t node = 0; node < size; ++node) ASSERT_EQ(tour.At(tour.PositionOf(node)), node);
      if (i % 2 == 0) continue;
      tour.Reverse(turn);
      ASSERT_EQ(tour.order(), before);
    }
  }
}

}  // namespace
}  // namespace slicefarm::ordering::array_tour_test
