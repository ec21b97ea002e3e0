#include "services/slicing/algo/placement/arranging/grid_positions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/geometry/convex.h"

namespace slicefarm::slicing::grid_positions_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr Coord kDistance = 6 * kNmPerMm;

Polygon Rectangle(double width, double height) {
  return ConvexHull(
      {{0, 0}, {FromMm(width), 0}, {FromMm(width), FromMm(height)}, {0, FromMm(height)}});
}
Point At(double x, double y) { return {FromMm(x), FromMm(y)}; }

TEST(GridPositions, PutsOneInTheMiddleAndFourAroundIt) {
  const Polygon bed = Rectangle(250, 210);
  EXPECT_THAT(GridPositions(bed, Rectangle(30, 20), kDistance, 1), ElementsAre(At(110, 95)));
  EXPECT_THAT(GridPositions(bed, Rectangle(30, 20), kDistance, 4),
              ElementsAre(At(92, 82), At(128, 82), At(92, 108), At(128, 108)));
}

TEST(GridPositions, FillsABedExactly) {
  // 8 columns and 6 rows: 6 x 36 - 6 = 210, 8 x 26 - 6 = 202.
  EXPECT_THAT(GridPositions(Rectangle(210, 202), Rectangle(30, 20), kDistance, 1000), SizeIs(48));
  EXPECT_THAT(GridPositions(Rectangle(209.9, 202), Rectangle(30, 20), kDistance, 1000), SizeIs(40));
  EXPECT_THAT(GridPositions(Rectangle(250, 210), Rectangle(30, 20), kDistance, 1000), SizeIs(56));
}

TEST(GridPositions, HasNoneForATooLargePart) {
  EXPECT_THAT(GridPositions(Rectangle(25, 100), Rectangle(30, 20), kDistance, 5), IsEmpty());
  EXPECT_THAT(GridPositions(Rectangle(30, 20), Rectangle(30, 20), kDistance, 5),
              ElementsAre(At(0, 0)));
}

TEST(GridPositions, KeepsWithinARoundBed) {
  Polygon bed;
  for (int i = 0; i < 72; ++i)
    bed.push_back({std::llround(100e6 * std::cos(i * std::numbers::pi / 36)),
                   std::llround(100e6 * std::sin(i * std::numbers::pi / 36))});
  const std::vector<Point> places =
      GridPositions(ConvexHull(bed), Rectangle(20, 20), kDistance, 999);
  EXPECT_GE(places.size(), 32u);
  for (const Point t : places)
    for (const Point corner : Rectangle(20, 20)) EXPECT_LE(Norm(t + corner), 100e6);
}

TEST(GridPositions, TakesADot) {
  EXPECT_THAT(GridPositions(Rectangle(20, 20), {{0, 0}}, 0, 9), SizeIs(9));
}

}  // namespace
}  // namespace slicefarm::slicing::grid_positions_test
