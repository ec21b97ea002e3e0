#include "common/geometry/measure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/geometry/between.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::measure_test {
namespace {

constexpr double kMm2 = 1e12;  // nm^2

Polygon Ring(std::string_view text) { return MakeLineOrDie(text); }

TEST(SignedArea, TurnsWithTheRing) {
  EXPECT_EQ(SignedArea(Ring("(0 0, 2 0, 2 3, 0 3)")), 6 * kMm2);
  EXPECT_EQ(SignedArea(Ring("(0 0, 0 3, 2 3, 2 0)")), -6 * kMm2);
  EXPECT_EQ(SignedArea({}), 0);
}

TEST(SignedArea, KeepsANanometreFarFromTheOrigin) {
  const Coord far = 2'000'000'000;
  EXPECT_EQ(SignedArea({{far, far}, {far + 1, far}, {far, far + 1}}), 0.5);
}

TEST(Area, TakesHolesOff) {
  EXPECT_EQ(
      Area(MakePolygonsOrDie("(0 0, 9 0, 9 9, 0 9) (1 1, 2 1, 2 2, 1 2) ; (20 0, 21 0, 21 1)")),
      (81 - 1 + 0.5) * kMm2);
}

TEST(Centroid, OfShapesWithAKnownOne) {
  EXPECT_EQ(Centroid(Ring("(0 0, 4 0, 4 2, 0 2)")), (Point{FromMm(2), FromMm(1)}));
  EXPECT_EQ(Centroid(Ring("(0 0, 3 0, 0 3)")), (Point{FromMm(1), FromMm(1)}));
  EXPECT_EQ(Centroid(Ring("(0 0, 0 3, 3 0)")), (Point{FromMm(1), FromMm(1)}));
  EXPECT_EQ(Centroid(Ring("(0 0, 2 0)")), (Point{FromMm(1), 0}));
}

TEST(Perimeter, ClosesTheRing) {
  EXPECT_EQ(Perimeter(Ring("(0 0, 3 0, 3 4)")), 12e6);
  EXPECT_EQ(Length(Ring("(0 0, 3 0, 3 4)")), 7e6);
}

TEST(Locate, IsExactOnTheBoundary) {
  const Polygon ring = Ring("(0 0, 4 0, 4 4, 2 1, 0 4)");
  EXPECT_EQ(Locate({FromMm(1), FromMm(1)}, ring), Side::kInside);
  EXPECT_EQ(Locate({FromMm(2), FromMm(2)}, ring), Side::kOutside);
  EXPECT_EQ(Locate({FromMm(3), FromMm(2.5)}, ring), Side::kBoundary);
  EXPECT_EQ(Locate({FromMm(3), FromMm(2.5) + 1}, ring), Side::kOutside);
  EXPECT_EQ(Locate({FromMm(3), FromMm(2.5) - 1}, ring), Side::kInside);
  EXPECT_EQ(Locate({FromMm(2), 0}, ring), Side::kBoundary);
  EXPECT_EQ(Locate({FromMm(4), FromMm(4)}, ring), Side::kBoundary);
  EXPECT_EQ(Locate({FromMm(5), 0}, ring), Side::kOutside);
}

TEST(Locate, SeesHoles) {
  const MultiPolygon frame = MakePolygonsOrDie("(0 0, 9 0, 9 9, 0 9) (3 3, 6 3, 6 6, 3 6)");
  EXPECT_EQ(Locate({FromMm(1), FromMm(1)}, frame[0]), Side::kInside);
  EXPECT_EQ(Locate({FromMm(4), FromMm(4)}, frame[0]), Side::kOutside);
  EXPECT_EQ(Locate({FromMm(3), FromMm(4)}, frame[0]), Side::kBoundary);
}

TEST(DistanceToSegment, BeyondTheEndsIsToTheEnd) {
  EXPECT_EQ(DistanceToSegment({5, 5}, {0, 0}, {10, 0}), 5);
  EXPECT_EQ(DistanceToSegment({-3, 4}, {0, 0}, {10, 0}), 5);
  EXPECT_EQ(DistanceToSegment({13, 4}, {0, 0}, {10, 0}), 5);
  EXPECT_EQ(DistanceToSegment({3, 4}, {0, 0}, {0, 0}), 5);
  EXPECT_EQ(NearestOnSegment({5, 5}, {0, 0}, {10, 0}), (Point{5, 0}));
  EXPECT_EQ(NearestOnSegment({-5, 5}, {0, 0}, {10, 0}), (Point{0, 0}));
}

TEST(Box, GrowsAndMeets) {
  Box box;
  EXPECT_TRUE(box.Empty());
  EXPECT_FALSE(box.Intersects(box));
  box.Add(Point{1, 2});
  box.Add(Point{-3, 5});
  EXPECT_EQ(box, (Box{{-3, 2}, {1, 5}}));
  EXPECT_TRUE(box.Intersects({{1, 5}, {9, 9}}));
  EXPECT_FALSE(box.Intersects({{2, 5}, {9, 9}}));
  EXPECT_TRUE(box.Grown(1).Intersects({{2, 5}, {9, 9}}));
}

TEST(PointBetween, HasItsShareOfTheWayBehind) {
  const Point a{10, -20}, b{-10, 21};
  EXPECT_EQ(PointBetween(a, b, 0), a);
  EXPECT_EQ(PointBetween(a, b, 1), b);
  EXPECT_EQ(PointBetween(a, b, 0.5), (Point{0, 1})) << "half a nanometre away from zero";
  EXPECT_EQ(PointBetween(a, a, 0.3), a);
}

}  // namespace
}  // namespace slicefarm::measure_test
