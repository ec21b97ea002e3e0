#include "services/ordering/algo/tours/point_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace slicefarm::ordering::point_tree_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(PointTree, Empty) {
  const PointTree tree({});
  EXPECT_EQ(tree.Nearest({0, 0}), PointTree::kNone);
}

TEST(PointTree, FindsAndForgets) {
  const std::vector<Vector2> points = {{0, 0}, {10, 0}, {20, 0}};
  PointTree tree(points);
  EXPECT_EQ(tree.Nearest({9, 1}), 1);
  tree.Remove(1);
  EXPECT_EQ(tree.Nearest({9, 1}), 0);
  tree.Remove(0);
  tree.Remove(2);
  EXPECT_EQ(tree.Nearest({9, 1}), PointTree::kNone);
  tree.Restore(2);
  EXPECT_EQ(tree.Nearest({9, 1}), 2);
}

TEST(PointTree, NoPlaceIsItsOwnNeighbour) {
  const std::vector<Vector2> points = {{0, 0}, {0, 0}, {5, 0}, {6, 0}};
  const PointTree tree(points);
  std::vector<uint32_t> found;
  tree.NearestFew({0, 0}, 0, 10, found);
  EXPECT_THAT(found, ElementsAre(1, 2, 3));
  tree.NearestFew({0, 0}, 0, 0, found);
  EXPECT_THAT(found, IsEmpty());
}

TEST(PointTree, AgreesWithLookingAtAll) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> coord(-50, 50);  // small, so that some places are equal
  std::vector<Vector2> points(300);
  for (Vector2& place : points) place = {1.0 * coord(random), 1.0 * coord(random)};
  PointTree tree(points);
  std::vector<uint32_t> left(points.size());
  for (uint32_t i = 0; i < left.size(); ++i) left[i] = i;
  while (!left.empty()) {
    const Vector2 query{1.0 * coord(random), 1.0 * coord(random)};
    const auto distance2 = [&](uint32_t i) {
      const double dx = points[i].x() - query.x();
      const double dy = points[i].y() - query.y();
      return dx * dx + dy * dy;
    };
    const auto nearer = [&](uint32_t a, uint32_t b) { return distance2(a) < distance2(b); };
    const uint32_t nearest = tree.Nearest(query);
    ASSERT_TRUE(std::binary_search(left.begin(), left.end(), nearest));
    const uint32_t want = *std::min_element(left.begin(), left.end(), nearer);
    ASSERT_EQ(distance2(nearest), distance2(want));

    std::vector<uint32_t> few;
    tree.NearestFew(query, left.back(), 5, few);
    std::vector<uint32_t> others;
    for (const uint32_t i : left) {
      if (i != left.back()) others.push_back(i);
    }
    ASSERT_EQ(few.size(), std::min<size_t>(5, others.size()));
    ASSERT_TRUE(std::is_sorted(few.begin(), few.end(), nearer));
    std::stable_sort(others.begin(), others.end(), nearer);
    for (size_t i = 0; i < few.size(); ++i) {
      ASSERT_EQ(distance2(few[i]), distance2(others[i]));
    }
    for (const bool right : {false, true}) {
      for (const bool above : {false, true}) {
        tree.NearestFew(query, PointTree::kNone, 3, few, PointTree::Quadrant{right, above});
        std::vector<uint32_t> there;
        for (const uint32_t i : left) {
          if ((points[i].x() >= query.x()) == right && (points[i].y() >= query.y()) == above)
            there.push_back(i);
        }
        std::stable_sort(there.begin(), there.end(), nearer);
        ASSERT_EQ(few.size(), std::min<size_t>(3, there.size()));
        for (size_t i = 0; i < few.size(); ++i) ASSERT_EQ(distance2(few[i]), distance2(there[i]));
      }
    }
    const size_t out = random() % left.size();
    tree.Remove(left[out]);
    left.erase(left.begin() + static_cast<ptrdiff_t>(out));
  }
}

}  // namespace
}  // namespace slicefarm::ordering::point_tree_test
