#include "services/exposure/algo/decompose/merge_corners.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::exposure::merge_corners_test {
namespace {

MultiPolygon Dented(Coord depth) {
  MultiPolygon islands = MakePolygonsOrDie("(0 0, 100 0, 100 100, 0 100)");
  islands[0].outer.insert(islands[0].outer.begin() + 1, Point{50 * kNmPerMm, depth});
  return islands;
}

TEST(MergeCorners, WithinBothLimits) {
  const double area = 0.5 * 100e6 * 1000;  // area of the dent
  EXPECT_EQ(MergeCorners(Dented(1000), {1001, area + 1})[0].outer.size(), 4u);
  EXPECT_EQ(MergeCorners(Dented(1000), {999, area + 1})[0].outer.size(), 5u);
  EXPECT_EQ(MergeCorners(Dented(1000), {1001, area - 1})[0].outer.size(), 5u);
  EXPECT_EQ(MergeCorners(Dented(-1000), {1001, area + 1})[0].outer.size(), 4u);
}

TEST(MergeCorners, StraightPointsAlwaysGo) {
  EXPECT_EQ(MergeCorners(Dented(0), {})[0].outer.size(), 4u);
}

TEST(MergeCorners, AFineArcKeepsItsArea) {
  // Each single corner is within the limit. Together they would remove half of the disc.
  Polygon ring;
  for (int i = 0; i < 1000; ++i)
    ring.push_back({std::llround(1e7 * std::cos(i * 0.00628318)),
                    std::llround(1e7 * std::sin(i * 0.00628318))});
  const double area = SignedArea(ring);
  const MultiPolygon merged = MergeCorners({{ring, {}}}, {INFINITY, 1e-6 * area});
  EXPECT_LT(merged[0].outer.size(), 1000u);
  EXPECT_NEAR(Area(merged), area, 1.1e-6 * area);
}

TEST(MergeCorners, KeepsACornerThatAnotherRingIsIn) {
  // The tip of a hole is in the bulge that would be cut off.
  MultiPolygon islands = Dented(-1000);
  islands[0].holes = {
      {{50 * kNmPerMm, -500}, {40 * kNmPerMm, 50 * kNmPerMm}, {60 * kNmPerMm, 50 * kNmPerMm}}};
  EXPECT_EQ(MergeCorners(islands, {2000, INFINITY})[0].outer[1], (Point{50 * kNmPerMm, -1000}));
}

TEST(MergeCorners, RingsOfNoAreaVanish) {
  EXPECT_TRUE(MergeCorners({{{{0, 0}, {5, 5}, {10, 10}}, {}}}, {}).empty());
}

}  // namespace
}  // namespace slicefarm::exposure::merge_corners_test
