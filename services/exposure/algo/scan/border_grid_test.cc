#include "services/exposure/algo/scan/border_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::exposure::border_grid_test {
namespace {

const char kFrame[] = "(0 0, 30 0, 30 30, 0 30) (10 10, 10 20, 20 20, 20 10)";

TEST(BorderGrid, OfAFrame) {
  const BorderGrid border(MakePolygonsOrDie(kFrame), 5e6);
  const auto keeps = [&](Coord x0, Coord y0, Coord x1, Coord y1, double distance) {
    return border.Keeps({x0 * kNmPerMm, y0 * kNmPerMm}, {x1 * kNmPerMm, y1 * kNmPerMm}, distance);
  };
  EXPECT_TRUE(keeps(4, 15, 4, 15, 4e6));
  EXPECT_FALSE(keeps(4, 15, 4, 15, 4.000001e6));
  EXPECT_TRUE(keeps(4, 4, 4, 26, 4e6));
  EXPECT_FALSE(keeps(4, 15, 26, 15, 0));      // across the hole
  EXPECT_FALSE(keeps(11, 15, 19, 15, 0));     // in the hole
  EXPECT_FALSE(keeps(25, 15, 35, 15, 0));     // from inside to outside
  EXPECT_FALSE(keeps(-9, 15, -8, 15, 0));     // outside
  EXPECT_TRUE(keeps(4, 12, 12, 4, 2.828e6));  // past the hole's corner
  EXPECT_FALSE(keeps(4, 12, 12, 4, 2.829e6));
}

TEST(BorderGrid, OfNothing) {
  const BorderGrid border({}, 1e6);
  EXPECT_FALSE(border.Keeps({0, 0}, {0, 0}, 0));
  EXPECT_FALSE(border.IsNear({0, 0}, 1e6));
  EXPECT_EQ(border.LongestRun({0, 0}, {1, 1}, 0), std::nullopt);
}

TEST(BorderGrid, IsNearInsideAndOutside) {
  const BorderGrid border(MakePolygonsOrDie(kFrame), 2e6);
  EXPECT_TRUE(border.IsNear({8'100'000, 15'000'000}, 2e6));
  EXPECT_FALSE(border.IsNear({7'900'000, 15'000'000}, 2e6));
  EXPECT_TRUE(border.IsNear({-1'900'000, 15'000'000}, 2e6));
  EXPECT_FALSE(border.IsNear({-1'500'000, -1'500'000}, 2e6));
}

TEST(BorderGrid, TheLongestRunBesideACorner) {
  const BorderGrid border(MakePolygonsOrDie(kFrame), 2e6);
  const auto run = border.LongestRun({5'000'000, 1'000'000}, {5'000'000, 29'900'000}, 2e6);
  ASSERT_TRUE(run);
  EXPECT_EQ(run->first, (Point{5'000'000, 2'000'000}));
  EXPECT_EQ(run->second, (Point{5'000'000, 28'000'000}));
  // The segment passes too near to a hole: its longer part ends where the hole's corner is 2 mm
  // away.
  const auto part = border.LongestRun({9'000'000, 3'000'000}, {9'000'000, 25'000'000}, 2e6);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->first, (Point{9'000'000, 3'000'000}));
  EXPECT_NEAR(static_cast<double>(part->second.y), 10e6 - std::sqrt(3e12), 2);
}

TEST(BorderGrid, StaysWhereALineRunsAlongTheBorder) {
  const BorderGrid border(MakePolygonsOrDie(kFrame), 3'000);
  const auto stays = [&](double x0, double y0, double x1, double y1) {
    return border.Stays({FromMm(x0), FromMm(y0)}, {FromMm(x1), FromMm(y1)}, 3'000);
  };
  EXPECT_TRUE(stays(0, 0, 30, 0));
  EXPECT_TRUE(stays(-0.002, -0.002, 30.002, -0.002));
  EXPECT_FALSE(stays(-0.004, 0, 30, 0));
  EXPECT_TRUE(stays(0, 10, 30, 10));      // along a side of the hole
  EXPECT_TRUE(stays(0, 10.002, 30, 10));  // slightly inside the hole
  EXPECT_FALSE(stays(0, 10.02, 30, 10));  // too far inside the hole
  EXPECT_FALSE(stays(0, 15, 30, 15));     // across the hole, ends on the border
  EXPECT_FALSE(stays(10, 10, 20, 20));    // from corner to corner
  EXPECT_TRUE(stays(5, 15, 5, 15));
  EXPECT_FALSE(stays(15, 15, 15, 15));
  EXPECT_FALSE(stays(-9, 15, -8, 15));
}

double SegmentDistance(Point a, Point b, const MultiPolygon& region) {
  double nearest = std::min(DistanceToBoundary(a, region), DistanceToBoundary(b, region));
  ForEachRing(region, [&](const Polygon& ring) {
    for (const Point p : ring) nearest = std::min(nearest, DistanceToSegment(p, a, b));
  });
  return nearest;
}

bool Meets(Point a, Point b, const MultiPolygon& region) {
  bool meets = false;
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point c = ring[i], d = ring[(i + 1) % ring.size()];
      meets = meets || ((Cross(b - a, c - a) < 0) != (Cross(b - a, d - a) < 0) &&
                        (Cross(d - c, a - c) < 0) != (Cross(d - c, b - c) < 0));
    }
  });
  return meets;
}

/// Random segments in random regions are compared with a test of all edges.
TEST(BorderGrid, IsWhatAllEdgesSay) {
  std::mt19937 random(7);
  int kept = 0, not_kept = 0;
  for (int i = 0; i < 300; ++i) {
    const MultiPolygon region = RandomIsland(random, {}, Uniform(random, 0.2, 20));
    const double reach = Uniform(random, 0, 5e5);
    const BorderGrid border(region, reach);
    const Box box = Bounds(region).Grown(200'000);
    for (int k = 0; k < 200; ++k) {
      const Point a = RandomPoint(random, box);
      const double length = k % 3 == 0 ? 1 : Uniform(random, 0, 0.2);
      const Point far = RandomPoint(random, box);
      const Point b = a + Point{std::llround(length * static_cast<double>(far.x - a.x)),
                                std::llround(length * static_cast<double>(far.y - a.y))};
      const double distance = SegmentDistance(a, b, region);
      const double asked = k % 2 == 0 ? 0 : Uniform(random, 0, reach);
      if (std::abs(distance - asked) < 1) continue;
      const bool expected = Inside(a, region) && distance >= asked && !Meets(a, b, region);
      ASSERT_EQ(border.Keeps(a, b, asked), expected) << ToText(region) << i << " " << k;
      ++(expected ? kept : not_kept);
      ASSERT_EQ(border.IsNear(a, asked), DistanceToBoundary(a, region) < asked);
      if (const auto run = border.LongestRun(a, b, asked)) {
        EXPECT_TRUE(Inside(run->first, region));
        EXPECT_GE(SegmentDistance(run->first, run->second, region), asked - 2);
      } else {
        EXPECT_FALSE(expected);
      }
    }
  }
  EXPECT_GT(kept, 5000);
  EXPECT_GT(not_kept, 5000);
}

/// Returns how far the farthest of many points of ab is outside, and the step between the points.
std::pair<double, double> FarthestOutside(Point a, Point b, const MultiPolygon& region) {
  constexpr int kSteps = 200;
  double farthest = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const Point p{a.x + (b.x - a.x) * i / kSteps, a.y + (b.y - a.y) * i / kSteps};
    if (!Inside(p, region)) farthest = std::max(farthest, DistanceToBoundary(p, region));
  }
  return {farthest, Distance(a, b) / kSteps + 2};
}

/// Random segments, many of them along an edge, are compared with points on them.
TEST(BorderGrid, StaysIsWhatPlacesOnTheLineSay) {
  std::mt19937 random(8);
  int stay = 0, stray = 0;
  for (int i = 0; i < 200; ++i) {
    const MultiPolygon region = RandomIsland(random, {}, Uniform(random, 0.2, 20));
    const double beyond = Uniform(random, 1'000, 2e5);
    const BorderGrid border(region, beyond);
    const Box box = Bounds(region).Grown(200'000);
    const std::vector<Polygon> rings = Rings(region);
    for (int k = 0; k < 60; ++k) {
      const Polygon& ring = rings[random() % rings.size()];
      const size_t at = random() % ring.size();
      const auto off = [&] { return std::llround(Uniform(random, -1.5, 1.5) * beyond); };
      Point a = ring[at] + Point{off(), off()};
      Point b = ring[(at + 1 + k % 2) % ring.size()] + Point{off(), off()};
      if (k % 3 == 0) a = RandomPoint(random, box);
      if (k % 9 == 0) b = RandomPoint(random, box);
      const auto [farthest, step] = FarthestOutside(a, b, region);
      if (farthest > beyond + 1) {
        EXPECT_FALSE(border.Stays(a, b, beyond)) << ToText(region) << i << " " << k;
        ++stray;
      } else if (farthest + step < beyond) {
        EXPECT_TRUE(border.Stays(a, b, beyond)) << ToText(region) << i << " " << k;
        ++stay;
      }
    }
  }
  EXPECT_GT(stay, 1000);
  EXPECT_GT(stray, 1000);
}

}  // namespace
}  // namespace slicefarm::exposure::border_grid_test
