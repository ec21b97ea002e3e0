#include "common/geometry/convex.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::convex_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Polygon RandomConvex(std::mt19937& random, Coord size, int points) {
  std::vector<Point> cloud;
  for (int i = 0; i < points; ++i)
    cloud.push_back({static_cast<Coord>(random() % size), static_cast<Coord>(random() % size)});
  return ConvexHull(cloud);
}

TEST(ConvexHull, DropsInnerAndCollinearAndDoublePoints) {
  EXPECT_THAT(ConvexHull({{9, 9}, {0, 0}, {9, 0}, {4, 0}, {3, 3}, {0, 9}, {0, 0}}),
              ElementsAre(Point{0, 0}, Point{9, 0}, Point{9, 9}, Point{0, 9}));
}

TEST(ConvexHull, OfLessThanThreePointsIsTheseInOrder) {
  EXPECT_THAT(ConvexHull({}), IsEmpty());
  EXPECT_THAT(ConvexHull({{5, 5}, {5, 5}}), ElementsAre(Point{5, 5}));
  EXPECT_THAT(ConvexHull({{5, 5}, {1, 1}, {3, 3}}), ElementsAre(Point{1, 1}, Point{5, 5}));
}

TEST(ConvexSum, OfTwoBoxesIsABox) {
  EXPECT_THAT(
      ConvexSum(ConvexHull({{0, 0}, {4, 0}, {4, 2}, {0, 2}}), ConvexHull({{1, 1}, {2, 3}, {1, 3}})),
      ConvexHull({{1, 1}, {5, 1}, {6, 3}, {6, 5}, {1, 5}}));
}

TEST(ConvexSum, TakesPointsSegmentsAndNothing) {
  const Polygon box = ConvexHull({{0, 0}, {4, 0}, {4, 2}, {0, 2}});
  EXPECT_EQ(ConvexSum(box, {{1, 1}}), Moved(box, {1, 1}));
  EXPECT_EQ(ConvexSum(box, {{0, 0}, {0, 3}}), ConvexHull({{0, 0}, {4, 0}, {4, 5}, {0, 5}}));
  EXPECT_EQ(ConvexSum({{0, 0}, {0, 3}}, {{1, 0}, {5, 0}}),
            ConvexHull({{1, 0}, {5, 0}, {5, 3}, {1, 3}}));
  EXPECT_THAT(ConvexSum(box, {}), IsEmpty());
  EXPECT_THAT(ConvexSum({{0, 0}, {2, 2}}, {{1, 1}, {2, 2}}), ElementsAre(Point{1, 1}, Point{4, 4}));
}

TEST(ConvexSum, IsTheHullOfAllSumsOfCorners) {
  std::mt19937 random(1);
  for (int round = 0; round < 2000; ++round) {
    const Coord size = round % 2 == 0 ? 6 : 100'000'000;
    const Polygon a = RandomConvex(random, size, 1 + random() % 8);
    const Polygon b = RandomConvex(random, size, 1 + random() % 8);
    std::vector<Point> sums;
    for (const Point p : a)
      for (const Point q : b) sums.push_back(p + q);
    ASSERT_EQ(ConvexSum(a, b), ConvexHull(sums)) << ToText(a) << ToText(b);
  }
}

TEST(DiscCover, ContainsTheDiscAndTouchesItsAxes) {
  EXPECT_THAT(DiscCover(0), ElementsAre(Point{0, 0}));
  for (const Coord radius : {1'000, 6'000'000, 20'000'000, 45'123'457}) {
    const Polygon cover = DiscCover(radius);
    for (size_t i = 0; i < cover.size(); ++i) {
      EXPECT_GE(DistanceToSegment({0, 0}, cover[i], cover[(i + 1) % cover.size()]), radius);
      EXPECT_LE(Norm(cover[i]), radius * (radius > 10'000'000 ? 1.005 : 1.02) + 2);
    }
    EXPECT_LE(Bounds(cover).max.x, radius + 1);
    EXPECT_GE(Bounds(cover).min.y, -radius - 1);
  }
}

TEST(StrictlyInside, LeavesTheBoundaryOut) {
  const Polygon box = ConvexHull({{0, 0}, {4, 0}, {4, 2}, {0, 2}});
  EXPECT_TRUE(StrictlyInside({1, 1}, box));
  EXPECT_FALSE(StrictlyInside({4, 1}, box));
  EXPECT_FALSE(StrictlyInside({5, 1}, box));
  EXPECT_FALSE(StrictlyInside({1, 0}, {{0, 0}, {4, 0}}));
}

TEST(StrictlyInside, AgreesWithLocate) {
  std::mt19937 random(3);
  for (int round = 0; round < 3000; ++round) {
    const Polygon a = RandomConvex(random, 12, 3 + random() % 9);
    const Point p = {static_cast<Coord>(random() % 12), static_cast<Coord>(random() % 12)};
    if (a.size() < 3) continue;
    ASSERT_EQ(StrictlyInside(p, a), Locate(p, a) == Side::kInside) << ToText(a) << ToText(p);
  }
}

TEST(ConvexDistance, IsThatOfTheNearestPoints) {
  const Polygon box = ConvexHull({{0, 0}, {400, 0}, {400, 200}, {0, 200}});
  EXPECT_DOUBLE_EQ(ConvexDistance(box, Moved(box, {700, 100})), 300);
  EXPECT_DOUBLE_EQ(ConvexDistance(box, Moved(box, {430, 240})), 50);
  EXPECT_EQ(ConvexDistance(box, Moved(box, {400, 0})), 0);
  EXPECT_EQ(ConvexDistance(box, Moved(box, {100, 10})), 0);
  EXPECT_DOUBLE_EQ(ConvexDistance(box, {{-30, -40}}), 50);
  EXPECT_GT(ConvexDistance(box, {}), 1e300);
}

TEST(ConvexDistance, AgreesWithAllPairsOfCornersAndEdges) {
  std::mt19937 random(2);
  for (int round = 0; round < 500; ++round) {
    const Polygon a = RandomConvex(random, 30'000'000, 3 + random() % 9);
    const Polygon b = Moved(RandomConvex(random, 30'000'000, 3 + random() % 9), {40'000'000, 0});
    double least = 1e300;
    for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)})
      for (const Point p : *from)
        for (size_t i = 0; i < to->size(); ++i)
          least = std::min(least, DistanceToSegment(p, (*to)[i], (*to)[(i + 1) % to->size()]));
    ASSERT_NEAR(ConvexDistance(a, b), least, 1);
  }
}

}  // namespace
}  // namespace slicefarm::convex_test
