#include "services/exposure/algo/scan/thin_walls.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::exposure::thin_walls_test {
namespace {

constexpr LineLevel kContour[] = {{0, 40'000}};

std::vector<Polyline> Walls(const MultiPolygon& outline) {
  auto walls = MiddleLines(outline, NarrowParts(outline, 40'000), kContour, {});
  EXPECT_TRUE(walls.ok()) << walls.status();
  return walls.ok() ? *std::move(walls) : std::vector<Polyline>{};
}

TEST(MiddleLines, OneLineForAStraightWall) {
  const auto walls = Walls(MakePolygonsOrDie("(0 0, 10 0, 10 0.05, 0 0.05)"));
  ASSERT_EQ(walls.size(), 1u);
  for (const Point p : walls[0]) EXPECT_EQ(p.y, 25'000);
  EXPECT_NEAR(Length(walls[0]), 10e6, 0.1e6);
}

TEST(MiddleLines, ARibOnABodyGetsOneAndTheBodyNone) {
  const auto walls =
      Walls(MakePolygonsOrDie("(0 0, 10 0, 10 5, 5.03 5, 5.03 9, 4.97 9, 4.97 5, 0 5)"));
  ASSERT_EQ(walls.size(), 1u);
  for (const Point p : walls[0]) {
    EXPECT_NEAR(static_cast<double>(p.x), 5e6, 2e3);
    EXPECT_GE(p.y, 4'900'000);
  }
  EXPECT_NEAR(Length(walls[0]), 4e6, 0.1e6);
}

TEST(MiddleLines, AThinRingIsFollowedAllTheWay) {
  Polyline circle;
  for (int i = 0; i < 60; ++i)
    circle.push_back(
        {std::llround(5e6 * std::cos(i * M_PI / 30)), std::llround(5e6 * std::sin(i * M_PI / 30))});
  MultiPolygon ring = {{circle, {}}};
  for (Point& p : circle) p = {p.x * 99 / 100, p.y * 99 / 100};
  ring[0].holes.push_back({circle.rbegin(), circle.rend()});
  const auto walls = Walls(ring);
  double length = 0;
  for (const Polyline& wall : walls) {
    length += Length(wall);
    for (const Point p : wall) EXPECT_NEAR(Norm(p), 4.975e6, 45e3);
  }
  EXPECT_NEAR(length, 2 * M_PI * 4.97e6, 1.5e6);
}

TEST(MiddleLines, ThickPartsAndCornersHaveNone) {
  EXPECT_TRUE(Walls(MakePolygonsOrDie("(0 0, 10 0, 10 5, 0 5)")).empty());
  EXPECT_TRUE(Walls(MakePolygonsOrDie("(0 0, 10 0, 5 9)")).empty());
  EXPECT_TRUE(Walls({}).empty());
}

}  // namespace
}  // namespace slicefarm::exposure::thin_walls_test
