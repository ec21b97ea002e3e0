#include "services/infill/algo/cells/voronoi_tile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace slicefarm::infill::voronoi_tile_test {
namespace {

Vector2 WayOf(const VoronoiTile& tile, const TileEdge& edge) {
  const Vector2 a = tile.vertices[static_cast<size_t>(edge.from)];
  const Vector2 b = tile.vertices[static_cast<size_t>(edge.to)];
  return {b.x() + edge.step_u - a.x(), b.y() + edge.step_v - a.y()};
}

double LengthOf(const VoronoiTile& tile) {
  double length = 0;
  for (const TileEdge& edge : tile.edges) {
    const Vector2 path = WayOf(tile, edge);
    length += std::sqrt(path.x() * path.x() + path.y() * path.y());
  }
  return length;
}

// On a torus V - E + F = 0, and with three edges in each vertex 3 V = 2 E.
TEST(RelaxedCells, ThreeEdgesMeetInEachVertex) {
  for (const int side : {6, 9, 16}) {
    const VoronoiTile tile = RelaxedCells(side, 3);
    const auto cells = static_cast<size_t>(side * side);
    EXPECT_EQ(tile.vertices.size(), 2 * cells);
    EXPECT_EQ(tile.edges.size(), 3 * cells);
    std::map<int32_t, int> degree;
    for (const TileEdge& edge : tile.edges) ++degree[edge.from], ++degree[edge.to];
    for (const auto& [vertex, count] : degree) EXPECT_EQ(count, 3) << vertex;
  }
}

TEST(RelaxedCells, NoEdgeIsLongerThanThreeCells) {
  const VoronoiTile tile = RelaxedCells(16, 0);
  ASSERT_FALSE(tile.edges.empty());
  for (const TileEdge& edge : tile.edges) {
    const Vector2 path = WayOf(tile, edge);
    EXPECT_LT(std::max(std::abs(path.x()), std::abs(path.y())), 3.0 / 16);
  }
}

// Hexagons have the least edge length for their number: 1.861 per cell of area 1 (Hales). Each
// round brings the cells nearer to this value.
TEST(RelaxedCells, BecomeRounderWithEachRound) {
  constexpr int kSide = 16;
  double before = 1e9;
  for (const int rounds : {0, 1, 4, 16, 64}) {
    const double by_cell = LengthOf(RelaxedCells(kSide, rounds)) / kSide;
    EXPECT_LT(by_cell, before) << rounds;
    EXPECT_GT(by_cell, 1.8612) << rounds;
    before = by_cell;
  }
  EXPECT_LT(before, 1.90);
}

TEST(RelaxedCells, AreTheSameEachTime) {
  const VoronoiTile one = RelaxedCells(8, 5), other = RelaxedCells(8, 5);
  ASSERT_EQ(one.vertices.size(), other.vertices.size());
  for (size_t i = 0; i < one.vertices.size(); ++i) {
    EXPECT_EQ(one.vertices[i].x(), other.vertices[i].x());
    EXPECT_EQ(one.vertices[i].y(), other.vertices[i].y());
  }
}

}  // namespace
}  // namespace slicefarm::infill::voronoi_tile_test
