#include "services/slicing/algo/placement/arranging/free_positions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "common/geometry/convex.h"
#include "common/geometry/moved.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::slicing::free_positions_test {
namespace {

using testing::Contains;
using testing::Each;
using testing::Eq;
using testing::IsEmpty;

Polygon Rectangle(double width, double height) {
  return ConvexHull(
      {{0, 0}, {FromMm(width), 0}, {FromMm(width), FromMm(height)}, {0, FromMm(height)}});
}
Point At(double x, double y) { return {FromMm(x), FromMm(y)}; }

TEST(FreePositions, OfAnEmptyBedAreItsCornersAndTheTarget) {
  const FreePositions free(Rectangle(100, 80), Rectangle(30, 20), At(40, 30));
  for (const Point want : {At(0, 0), At(70, 0), At(70, 60), At(0, 60), At(40, 30), At(40, 0)})
    EXPECT_THAT(free.Positions(), Contains(want)) << ToText(want);
  EXPECT_TRUE(free.Allowed(At(70, 60)));
  EXPECT_FALSE(free.Allowed({FromMm(70) + 1, 0}));
}

TEST(FreePositions, OfAPartAsLargeAsTheBedIsOne) {
  const FreePositions free(Rectangle(100, 80), Rectangle(100, 80), At(3, 3));
  EXPECT_THAT(free.Positions(), Contains(At(0, 0)));
  EXPECT_THAT(free.Positions(), Each(Eq(At(0, 0))));
}

TEST(FreePositions, OfATooLargePartAreNone) {
  FreePositions free(Rectangle(100, 80), Rectangle(100.001, 20), At(0, 0));
  EXPECT_THAT(free.Positions(), IsEmpty());
  free.AddObstacles({Rectangle(5, 5)});
  EXPECT_THAT(free.Positions(), IsEmpty());
  EXPECT_FALSE(free.Allowed(At(0, 0)));
}

TEST(FreePositions, FindsASlotThatFitsExactly) {
  FreePositions free(Rectangle(100, 80), Rectangle(20, 80), At(0, 0));
  // Parts of 40 x 80 are at both ends of the bed; the translations in between are free.
  const Polygon beside = Moved(Rectangle(60, 160), At(-20, -80));
  free.AddObstacles({beside, Moved(beside, At(60, 0))});
  EXPECT_THAT(free.Positions(), Contains(At(40, 0)));
  EXPECT_THAT(free.Positions(), Each(Eq(At(40, 0))));
}

TEST(FreePositions, AreAllowedAndHoldTheNearestToTheTarget) {
  std::mt19937 random(1);
  const Polygon bed = Rectangle(100, 100), part = Rectangle(1, 1);
  for (int round = 0; round < 100; ++round) {
    const Point target = At(20 + random() % 60, 20 + random() % 60);
    FreePositions together(bed, part, target), single(bed, part, target);
    std::vector<Polygon> obstacles;
    for (int i = 0; i < 12; ++i) {
      std::vector<Point> cloud;
      for (int k = 0; k < 9; ++k) cloud.push_back(At(random() % 50, random() % 50));
      obstacles.push_back(Moved(ConvexHull(cloud), At(random() % 60, random() % 60)));
      single.AddObstacles({obstacles.back()});
    }
    together.AddObstacles(obstacles);
    const auto nearest = [&](const FreePositions& free) {
      double least = 1e300;
      for (const Point t : free.Positions()) {
        EXPECT_TRUE(free.Allowed(t));
        least = std::min(least, Distance(t, target));
      }
      return least;
    };
    const double best = nearest(together);
    EXPECT_EQ(best, nearest(single));
    // No allowed point of a coarse grid is nearer.
    for (Coord x = 0; x <= 99; ++x)
      for (Coord y = 0; y <= 99; ++y)
        if (together.Allowed(At(x, y))) {
          EXPECT_GE(Distance(At(x, y), target) + 1500, best);
        }
  }
}

}  // namespace
}  // namespace slicefarm::slicing::free_positions_test
