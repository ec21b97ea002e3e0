#include "services/infill/algo/cells/voronoi_tile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace slicefarm::infill::voronoi_tile_test {
namespace {

Vec WayOf(const VoronoiTile& tile, const TileEdge& edge) {
  const Vec a = tile.vertices[static_cast<size_t>(edge.from)];
  const Vec b = tile.vertices[static_cast<size_t>(edge.to)];
  return {b.u + edge.step_u - a.u, b.v + edge.step_v - a.v};
}

double LengthOf(const VoronoiTile& tile) {
  double length = 0;
  for (const TileEdge& edge : tile.edges) {
    const Vec way = WayOf(tile, edge);
    length += std::sqrt(way.u * way.u + way.v * way.v);
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
  for (const TileEdge& edge : tile.edges) {
    const Vec way = WayOf(tile, edge);
    EXPECT_LT(std::max(std::abs(way.u), std::abs(way.v)), 3.0 / 16);
  }
}

// Hexagons have the least edge for their number: 1.861 a cell of area 1 (Hales). Cells come nearer
// to that with each round.
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
    EXPECT_EQ(one.vertices[i].u, other.vertices[i].u);
    EXPECT_EQ(one.vertices[i].v, other.vertices[i].v);
  }
}

}  // namespace
}  // namespace slicefarm::infill::voronoi_tile_test
