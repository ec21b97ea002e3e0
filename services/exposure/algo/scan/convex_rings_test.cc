#include "services/exposure/algo/scan/convex_rings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/convex.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/predicates.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::exposure::convex_rings_test {
namespace {

double AreaOf(const ConvexRing& ring) {
  double area = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vector2 a = ring[i], b = ring[(i + 1) % ring.size()];
    area += (a.x() * b.y() - b.x() * a.y()) / 2;
  }
  return area;
}

TEST(ConvexInsets, OfASquare) {
  const Polygon square = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)")[0].outer;
  ConvexInsets insets(square, 1);
  EXPECT_EQ(AreaOf(insets.At(1e6)), 64e12);
  EXPECT_EQ(AreaOf(insets.At(4e6)), 4e12);
  EXPECT_TRUE(insets.At(5e6).empty());
  EXPECT_TRUE(insets.At(6e6).empty());
}

TEST(ConvexInsets, CoordinatesHaveAScale) {
  const Polygon square = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)")[0].outer;
  EXPECT_NEAR(AreaOf(ConvexInsets(square, 1000).At(1e3)), 64e6, 1);
}

TEST(ConvexInsets, Depth) {
  const struct {
    const char* polygon;
    double depth;
  } cases[] = {{"(0 0, 10 0, 10 10, 0 10)", 5e6},
               {"(0 0, 30 0, 30 10, 0 10)", 5e6},
               {"(0 0, 3 0, 0 4)", 1e6},
               {"(0 0, 100 0, 50 0.1)", 49'999.95}};
  for (const auto& c : cases) {
    const double depth = ConvexInsets(MakePolygonsOrDie(c.polygon)[0].outer, 1).Depth();
    EXPECT_GE(depth, c.depth - 1) << c.polygon;
    EXPECT_LE(depth, c.depth + 1'001) << c.polygon;
  }
}

/// 9.05 mm are 45 rings and a quarter. Beginning with one ring, all rings are shifted by a distance
/// that makes the innermost ring's sides a pitch apart.
TEST(ConvexRings, OfATurnFitTheMiddle) {
  const Polygon block = MakePolygonsOrDie("(0 0, 9.05 0, 9.05 20, 0 20)")[0].outer;
  RingFill fill{.pitch_nm = 1e5, .first_nm = 5e4};
  std::set<size_t> where;
  for (int32_t layer = 0; layer < 100; ++layer) {
    fill.turn = RingTurnOf(layer);
    const std::vector<Polyline> rings = ConvexRings(block, 1, fill);
    ASSERT_EQ(rings.size(), 46u);
    const auto left = [&](size_t k) { return static_cast<double>(Bounds(rings[k]).min.x); };
    const Box middle = Bounds(rings.back());
    EXPECT_NEAR(static_cast<double>(middle.max.x - middle.min.x), 1e5, 2'002);
    size_t nearer = 0;
    for (size_t k = 1; k < rings.size(); ++k) {
      if (left(k) - left(k - 1) > 99'000) continue;
      EXPECT_EQ(nearer, 0u);
      EXPECT_NEAR(left(k) - left(k - 1), 25'000, 1'002);
      nearer = k;
    }
    where.insert(nearer);
  }
  EXPECT_EQ(where.size(), 45u);  // each position occurs once
}

TEST(ConvexRings, EveryFifthOfATurnReachesIntoCorners) {
  const Polygon square = MakePolygonsOrDie("(0 0, 8 0, 8 8, 0 8)")[0].outer;
  RingFill fill{.pitch_nm = 8e4, .first_nm = 4e4, .corners = true, .spurs = {.spot_nm = 8e4}};
  std::vector<int> spurred(50);
  for (int32_t layer = 0; layer < kCornerTurns; ++layer) {
    fill.turn = RingTurnOf(layer);
    const std::vector<Polyline> rings = ConvexRings(square, 1, fill);
    ASSERT_EQ(rings.size(), spurred.size());
    for (size_t k = 0; k < rings.size(); ++k) spurred[k] += rings[k].size() > 5 ? 1 : 0;
  }
  // Exceptions are the outermost ring, which has the region's border around it, and the middle
  // rings.
  for (size_t k = 0; k < spurred.size(); ++k) EXPECT_EQ(spurred[k], k > 0 && k < 47 ? 1 : 0) << k;
}

/// Insets of random convex polygons are compared with the offset by Clipper.
TEST(ConvexInsets, AreThoseOfAnotherOffset) {
  std::mt19937 random(3);
  for (int i = 0; i < 1000; ++i) {
    const Polygon hull = ConvexHull(RandomStar(random, 10, Uniform(random, 0.1, 1)));
    if (hull.size() < 3) continue;
    ConvexInsets insets(hull, 1);
    for (double distance = 0.3e6; distance < 12e6; distance += 0.7e6) {
      const ConvexRing ring = insets.At(distance);
      const double other =
          Area(Offset({{hull, {}}}, -static_cast<Coord>(distance), {.miter_limit = 100}));
      EXPECT_NEAR(ring.empty() ? 0 : AreaOf(ring), other, 50 * 1e6)
          << ToText(hull) << " at " << distance;
    }
    if (::testing::Test::HasFailure()) break;
  }
}

TEST(SpineOf, RunsAlongTheMiddleOfAStrip) {
  const Spine spine = SpineOf({{0, 0}, {100, 0}, {100, 10}, {0, 10}});
  EXPECT_EQ(spine.width_nm, 10);
  EXPECT_NEAR(spine.from.y(), 5, 1e-9);
  EXPECT_NEAR(std::abs(spine.to.x() - spine.from.x()), 100, 1e-9);
}

TEST(ConvexRings, OfASquareAreAPitchApart) {
  const Polygon square = MakePolygonsOrDie("(0 0, 1 0, 1 1, 0 1)")[0].outer;
  const auto rings = ConvexRings(square, 1, {.pitch_nm = 100'000, .first_nm = 50'000});
  ASSERT_EQ(rings.size(), 5u);
  for (size_t k = 0; k < rings.size(); ++k) {
    EXPECT_EQ(rings[k].size(), 5u);
    EXPECT_EQ(rings[k].front(), rings[k].back());
    const Box box = Bounds(rings[k]);
    EXPECT_EQ(box.min.x, static_cast<Coord>(50'000 + 100'000 * k));
    EXPECT_EQ(box.max.y, static_cast<Coord>(950'000 - 100'000 * k));
  }
}

TEST(ConvexRings, WhatIsLeftInTheMiddleIsScannedOnce) {
  const Polygon strip = MakePolygonsOrDie("(0 0, 2 0, 2 0.26, 0 0.26)")[0].outer;
  const auto rings = ConvexRings(strip, 1, {.pitch_nm = 100'000, .first_nm = 50'000});
  ASSERT_EQ(rings.size(), 2u);
  EXPECT_EQ(rings[1].size(), 2u);
  EXPECT_EQ(rings[1][0].y, 130'000);
}

TEST(ConvexRings, AThinPieceIsScannedOnce) {
  const auto rings = ConvexRings(MakePolygonsOrDie("(0 0, 2 0, 2 0.09, 0 0.09)")[0].outer, 1,
                                 {.pitch_nm = 100'000, .first_nm = 50'000});
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(rings[0].size(), 2u);
}

TEST(ConvexRings, KeepTheirDistanceFromTheBorder) {
  std::mt19937 random(4);
  int points = 0;
  for (int i = 0; i < 500; ++i) {
    const Polygon hull = ConvexHull(RandomStar(random, 3, Uniform(random, 0.1, 1)));
    if (hull.size() < 3) continue;
    const auto rings = ConvexRings(hull, 1, {.pitch_nm = 80'000, .first_nm = 40'000});
    for (const Polyline& ring : rings) {
      if (ring.size() < 4) continue;
      for (const Point p : ring) {
        ++points;
        EXPECT_EQ(Locate(p, hull), Side::kInside);
        EXPECT_GE(DistanceToBoundary(p, {{hull, {}}}), 40'000 - 2);
      }
    }
  }
  EXPECT_GT(points, 1'000);
}

/// With every turn, rings and the tips of spurs keep the first ring's distance from a random
/// piece's border.
TEST(ConvexRings, OfATurnStayInside) {
  std::mt19937 random(11);
  int points = 0;
  for (int i = 0; i < 400; ++i) {
    const Polygon hull = ConvexHull(RandomStar(random, 9, Uniform(random, 0.1, 1)));
    if (hull.size() < 3) continue;
    RingFill fill{.pitch_nm = 8e4, .first_nm = 3e4, .corners = true, .spurs = {.spot_nm = 8e4}};
    fill.turn = RingTurnOf(i);
    const std::vector<Polyline> rings = ConvexRings(hull, 1, fill);
    for (const Polyline& ring : rings)
      for (const Point p : ring) {
        ++points;
        ASSERT_TRUE(Inside(p, {{hull, {}}})) << i;
        if (ring.size() == 2) continue;
        ASSERT_GE(DistanceToBoundary(p, {{hull, {}}}), 29'998) << i;
      }
  }
  EXPECT_GT(points, 1'000);
}

}  // namespace
}  // namespace slicefarm::exposure::convex_rings_test
