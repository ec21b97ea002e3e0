#include "services/ordering/algo/endpoint_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace slicefarm::ordering {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(EndpointTree, Empty) {
  const EndpointTree tree({});
  EXPECT_EQ(tree.Nearest({0, 0}), EndpointTree::kNone);
}

TEST(EndpointTree, FindsAndForgets) {
  const std::vector<Point> points = {{0, 0}, {10, 0}, {20, 0}};
  EndpointTree tree(points);
  EXPECT_EQ(tree.Nearest({9, 1}), 1);
  tree.Remove(1);
  EXPECT_EQ(tree.Nearest({9, 1}), 0);
  tree.Remove(0);
  tree.Remove(2);
  EXPECT_EQ(tree.Nearest({9, 1}), EndpointTree::kNone);
}

TEST(EndpointTree, TheOtherEndOfALegIsNoNeighbour) {
  const std::vector<Point> points = {{0, 0}, {1, 0}, {5, 0}, {6, 0}};
  const EndpointTree tree(points);
  std::vector<uint32_t> found;
  tree.NearestFew({0, 0}, 0, 10, found);
  EXPECT_THAT(found, ElementsAre(2, 3));
  tree.NearestFew({0, 0}, 0, 0, found);
  EXPECT_THAT(found, IsEmpty());
}

TEST(EndpointTree, AgreesWithLookingAtAll) {
  std::mt19937 random(1);
  std::uniform_int_distribution<Coord> coord(-50, 50);  // small, so that points coincide
  std::vector<Point> points(300);
  for (Point& point : points) point = {coord(random), coord(random)};
  EndpointTree tree(points);
  std::vector<uint32_t> left(points.size());
  for (uint32_t i = 0; i < left.size(); ++i) left[i] = i;
  while (!left.empty()) {
    const Point query{coord(random), coord(random)};
    const auto nearer = [&](uint32_t a, uint32_t b) {
      return SquaredNorm(points[a] - query) < SquaredNorm(points[b] - query);
    };
    const uint32_t nearest = tree.Nearest(query);
    ASSERT_TRUE(std::binary_search(left.begin(), left.end(), nearest));
    const uint32_t want = *std::min_element(left.begin(), left.end(), nearer);
    ASSERT_EQ(SquaredNorm(points[nearest] - query), SquaredNorm(points[want] - query));

    std::vector<uint32_t> few;
    tree.NearestFew(query, left.back(), 5, few);
    std::vector<uint32_t> others;
    for (const uint32_t i : left) {
      if (i / 2 != left.back() / 2) others.push_back(i);
    }
    ASSERT_EQ(few.size(), std::min<size_t>(5, others.size()));
    ASSERT_TRUE(std::is_sorted(few.begin(), few.end(), nearer));
    std::stable_sort(others.begin(), others.end(), nearer);
    for (size_t i = 0; i < few.size(); ++i) {
      ASSERT_EQ(SquaredNorm(points[few[i]] - query), SquaredNorm(points[others[i]] - query));
    }
    const size_t out = random() % left.size();
    tree.Remove(left[out]);
    left.erase(left.begin() + static_cast<ptrdiff_t>(out));
  }
}

}  // namespace
}  // namespace slicefarm::ordering
