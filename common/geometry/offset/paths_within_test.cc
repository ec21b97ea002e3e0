#include "common/geometry/offset/paths_within.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"

namespace slicefarm::paths_within_test {
namespace {

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

MultiPolygon Box(double x0, double y0, double x1, double y1) {
  return {{{Mm(x0, y0), Mm(x1, y0), Mm(x1, y1), Mm(x0, y1)}, {}}};
}

/// Returns a bed of 256 mm without its front left corner.
MultiPolygon WithoutCorner() { return Difference(Box(0, 0, 256, 256), Box(0, 0, 18, 28)); }

double LengthMm(Point a, const std::vector<Point>& corners, Point b) {
  Polyline path = {a};
  path.insert(path.end(), corners.begin(), corners.end());
  path.push_back(b);
  return ToMm(Length(path));
}

TEST(PathsWithin, AreStraightWhereNothingIsInTheWay) {
  const PathsWithin paths(WithoutCorner());
  struct Case {
    const char* name;
    Point a, b;
  };
  for (const Case& each : {Case{"across", Mm(100, 100), Mm(200, 20)},
                           Case{"along an edge of the area", Mm(18, 1), Mm(18, 28)},
                           Case{"along the edge of the bed", Mm(18, 0), Mm(256, 0)},
                           Case{"past the corner", Mm(18, 28), Mm(200, 200)}})
    EXPECT_THAT(paths.Between(each.a, each.b), testing::IsEmpty()) << each.name;
}

TEST(PathsWithin, LeadRoundACorner) {
  const PathsWithin paths(WithoutCorner());
  const Point a = Mm(20, 1), b = Mm(1, 30);
  const std::vector<Point> corners = paths.Between(a, b);
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_GT(corners[0].x, FromMm(18));
  EXPECT_GT(corners[0].y, FromMm(28));
  EXPECT_LT(Distance(corners[0], Mm(18, 28)), FromMm(0.51));
  EXPECT_EQ(paths.Between(b, a), corners);
}

TEST(PathsWithin, TakeTheShorterWayRoundAnIsland) {
  const PathsWithin paths(Difference(Box(0, 0, 100, 100), Box(40, 30, 60, 80)));
  const Point a = Mm(20, 50), b = Mm(80, 50);
  const std::vector<Point> corners = paths.Between(a, b);
  ASSERT_EQ(corners.size(), 2u);
  EXPECT_LT(corners[0].y, FromMm(30)) << "the front is nearer";
  const double shortest = LengthMm(a, {Mm(40, 30), Mm(60, 30)}, b);
  EXPECT_GE(LengthMm(a, corners, b), shortest);
  EXPECT_LE(LengthMm(a, corners, b), shortest + 1);
}

TEST(PathsWithin, KeepsEveryLegOutOfTheIslands) {
  MultiPolygon islands = Box(20, 0, 30, 70);
  for (const MultiPolygon& more : {Box(45, 30, 55, 100), Box(70, 0, 80, 60)})
    islands = Union(islands, more);
  const PathsWithin paths(Difference(Box(0, 0, 100, 100), islands));
  const Point a = Mm(5, 5), b = Mm(95, 5);
  std::vector<Point> path = paths.Between(a, b);
  ASSERT_GE(path.size(), 4u);
  path.insert(path.begin(), a);
  path.push_back(b);
  for (size_t i = 1; i < path.size(); ++i)
    EXPECT_THAT(paths.Between(path[i - 1], path[i]), testing::IsEmpty()) << i;
}

TEST(PathsWithin, StayStraightWhereNoWayLeads) {
  const PathsWithin paths(WithoutCorner());
  EXPECT_THAT(paths.Between(Mm(-5, 100), Mm(100, 100)), testing::IsEmpty()) << "from outside";
  EXPECT_THAT(paths.Between(Mm(10, 10), Mm(1, 100)), testing::IsEmpty()) << "from the area";
  EXPECT_THAT(PathsWithin({}).Between(Mm(0, 0), Mm(1, 1)), testing::IsEmpty()) << "no region";
  const PathsWithin halves(Difference(Box(0, 0, 100, 100), Box(40, -1, 60, 101)));
  EXPECT_THAT(halves.Between(Mm(1, 1), Mm(99, 1)), testing::IsEmpty()) << "cut in two";
}

}  // namespace
}  // namespace slicefarm::paths_within_test
