#include "services/planning/algo/rings/region_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "services/planning/algo/seams/rings_test.h"

namespace slicefarm::planning::region_edges_test {
namespace {

/// Returns the nearest distance over all edges, and true if the point is in the solid.
std::pair<double, bool> Judged(Point p, const MultiPolygon& outlines) {
  double least = INFINITY;
  bool inside = false;
  for (const PolygonWithHoles& island : outlines)
    inside = inside || Locate(p, island) != Side::kOutside;
  ForEachRing(outlines, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i)
      least = std::min(least, DistanceToSegment(p, ring[i], ring[(i + 1) % ring.size()]));
  });
  return {least, inside};
}

TEST(RegionEdges, FindsWhatASearchOfAllEdgesFinds) {
  const MultiPolygon shapes[] = {
      MakePolygonsOrDie("(0 0, 40 0, 40 30, 22 3, 0 30) (5 2, 4 9, 12 4) ; (50 0, 50.2 0, 50 25)"),
      {{CircleRing(Mm(10, 10), 9, 300), {}}},
      MakePolygonsOrDie("(0 0, 900 1, 900 3, 0 2)")};
  std::mt19937 random(1);
  for (const MultiPolygon& outlines : shapes) {
    const RegionEdges index(outlines);
    const Box box = Bounds(outlines).Grown(FromMm(4));
    std::uniform_int_distribution<Coord> x(box.min.x, box.max.x), y(box.min.y, box.max.y);
    for (int i = 0; i < 2000; ++i) {
      const Point p{x(random), y(random)};
      const auto [distance, inside] = Judged(p, outlines);
      const auto hit = index.Nearest(p, FromMm(3));
      ASSERT_EQ(hit.has_value(), distance <= FromMm(3)) << p.x << " " << p.y;
      if (!hit) continue;
      EXPECT_NEAR(hit->distance_nm, distance, 2);
      EXPECT_EQ(hit->inside, inside) << p.x << " " << p.y;
    }
  }
}

TEST(RegionEdges, NamesTheRingAndThePlaceOnIt) {
  const RegionEdges index(
      MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20) (5 5, 5 15, 15 15, 15 5) ; (30 0, 40 0, 35 9)"));
  const auto hit = index.Nearest(Mm(6, 12.5), FromMm(2));
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->ring, 1);
  EXPECT_EQ(hit->edge, 0);
  EXPECT_DOUBLE_EQ(hit->share, 0.75);
  EXPECT_EQ(hit->distance_nm, 1e6);
  EXPECT_FALSE(hit->inside);
  EXPECT_EQ(index.Nearest(Mm(35, 10), FromMm(2))->ring, 2);
}

TEST(RegionEdges, OfNothingHasNothing) {
  EXPECT_FALSE(RegionEdges({}).Nearest({}, FromMm(1)).has_value());
}

std::vector<RegionEdges::Edge> EdgesOf(const MultiPolygon& region) {
  std::vector<RegionEdges::Edge> edges;
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i)
      edges.push_back({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], 0, 0});
  });
  return edges;
}

TEST(RegionEdges, AnswersAsLookingAtAllEdgesDoes) {
  std::mt19937 random(5);
  for (int k = 0; k < 40; ++k) {
    const MultiPolygon region = RandomIsland(random, {FromMm(3), -FromMm(7)}, 15);
    const RegionEdges grid(region);
    const std::vector<RegionEdges::Edge> edges = EdgesOf(region);
    for (int i = 0; i < 100; ++i) {
      const Point p{FromMm(Uniform(random, -30, 30)), FromMm(Uniform(random, -30, 30))};
      double nearest = 1e18;
      for (const RegionEdges::Edge& edge : edges)
        nearest = std::min(nearest, DistanceToSegment(p, edge.a, edge.b));
      const auto got = grid.Nearest(p);
      ASSERT_TRUE(got.has_value());
      EXPECT_NEAR(got->distance_nm, nearest, 2);
      EXPECT_EQ(grid.IsInside(p), Inside(p, region)) << p.x << " " << p.y;
      const Point q = p + Point{FromMm(Uniform(random, -9, 9)), FromMm(Uniform(random, -9, 9))};
      const std::vector<RegionEdges::Edge> near = grid.Near(p, q);
      for (const RegionEdges::Edge& edge : edges) {
        // No edge that the segment crosses may be missing.
        const bool crosses =
            (Cross(q - p, edge.a - p) > 0) != (Cross(q - p, edge.b - p) > 0) &&
            (Cross(edge.b - edge.a, p - edge.a) > 0) != (Cross(edge.b - edge.a, q - edge.a) > 0);
        if (!crosses) continue;
        EXPECT_TRUE(std::ranges::any_of(near, [&](const RegionEdges::Edge& other) {
          return other.a == edge.a && other.b == edge.b;
        }));
      }
    }
  }
}

TEST(RegionEdges, OfNothingIsNearNothing) {
  const RegionEdges none({});
  EXPECT_FALSE(none.Nearest({}).has_value());
  EXPECT_FALSE(none.IsInside({}));
  EXPECT_TRUE(none.Near({}, {1, 1}).empty());
}

}  // namespace
}  // namespace slicefarm::planning::region_edges_test
