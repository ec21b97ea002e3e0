#include "services/planning/algo/infill/edge_grid.h"

#include <gtest/gtest.h>

#include <random>

#include "common/geometry/random_islands_test.h"

namespace slicefarm::planning {
namespace {

std::vector<Edge> EdgesOf(const MultiPolygon& region) {
  std::vector<Edge> edges;
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i)
      edges.push_back({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]});
  });
  return edges;
}

TEST(EdgeGrid, AnswersAsLookingAtAllEdgesDoes) {
  std::mt19937 random(5);
  for (int k = 0; k < 40; ++k) {
    const MultiPolygon region = RandomIsland(random, {FromMm(3), -FromMm(7)}, 15);
    const EdgeGrid grid(region);
    const std::vector<Edge> edges = EdgesOf(region);
    for (int i = 0; i < 100; ++i) {
      const Point p{FromMm(Uniform(random, -30, 30)), FromMm(Uniform(random, -30, 30))};
      double nearest = 1e18;
      for (const Edge& edge : edges)
        nearest = std::min(nearest, DistanceToSegment(p, edge.a, edge.b));
      const auto got = grid.NearestTo(p);
      ASSERT_TRUE(got.has_value());
      EXPECT_NEAR(got->distance_nm, nearest, 2);
      EXPECT_EQ(grid.IsInside(p), Inside(p, region)) << p.x << " " << p.y;
      const Point q = p + Point{FromMm(Uniform(random, -9, 9)), FromMm(Uniform(random, -9, 9))};
      const std::vector<Edge> near = grid.Near(p, q);
      for (const Edge& edge : edges) {
        // No edge that the segment crosses is missing.
        const bool crosses =
            (Cross(q - p, edge.a - p) > 0) != (Cross(q - p, edge.b - p) > 0) &&
            (Cross(edge.b - edge.a, p - edge.a) > 0) != (Cross(edge.b - edge.a, q - edge.a) > 0);
        if (!crosses) continue;
        EXPECT_TRUE(std::ranges::any_of(
            near, [&](const Edge& other) { return other.a == edge.a && other.b == edge.b; }));
      }
    }
  }
}

TEST(EdgeGrid, OfNothingHasNothing) {
  const EdgeGrid none({});
  EXPECT_FALSE(none.NearestTo({}).has_value());
  EXPECT_FALSE(none.IsInside({}));
  EXPECT_TRUE(none.Near({}, {1, 1}).empty());
}

}  // namespace
}  // namespace slicefarm::planning
