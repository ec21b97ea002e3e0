#include "services/planning/algo/infill/grid_points.h"

#include <gtest/gtest.h>

#include <random>

#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::planning::grid_points_test {
namespace {

TEST(GridPoints, AreThoseOfTheGridInside) {
  const auto points =
      GridPoints(MakePolygonsOrDie("(-1.5 -0.5, 2.5 -0.5, 2.5 1.5, -1.5 1.5)"), kNmPerMm);
  EXPECT_EQ(points.size(), 4u * 2u);
  EXPECT_EQ(points.front(), (Point{-kNmPerMm, 0}));
  EXPECT_EQ(points.back(), (Point{2 * kNmPerMm, kNmPerMm}));
  EXPECT_TRUE(GridPoints({}, 5).empty());
}

TEST(GridPoints, AreAllInsideAndAsManyAsTheAreaHas) {
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i) {
    const MultiPolygon region = RandomIsland(random, {0, 0}, 20);
    const Coord step = 250'000;
    const auto points = GridPoints(region, step);
    for (const Point p : points) EXPECT_TRUE(Inside(p, region));
    double edge = 0;
    ForEachRing(region, [&](const Polygon& ring) { edge += Perimeter(ring); });
    const auto cell = static_cast<double>(step);
    EXPECT_NEAR(static_cast<double>(points.size()), Area(region) / cell / cell, edge / cell + 4);
  }
}

}  // namespace
}  // namespace slicefarm::planning::grid_points_test
