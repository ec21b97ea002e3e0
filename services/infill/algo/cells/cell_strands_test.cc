#include "services/infill/algo/cells/cell_strands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace slicefarm::infill::cell_strands_test {
namespace {

constexpr int kSide = 10;

double Between(Vector2 a, Vector2 b) {
  return std::sqrt((a.x() - b.x()) * (a.x() - b.x()) + (a.y() - b.y()) * (a.y() - b.y()));
}

double EdgeLength(const VoronoiTile& tile, size_t edge) {
  const TileEdge& at = tile.edges[edge];
  const Vector2 b = tile.vertices[static_cast<size_t>(at.to)];
  return Between(tile.vertices[static_cast<size_t>(at.from)],
                 {b.x() + at.step_u, b.y() + at.step_v});
}

TEST(StrandTile, EachVertexHasOneDoubledEdge) {
  const VoronoiTile cells = RelaxedCells(kSide, 10);
  const StrandTile tile(cells);
  std::vector<int> doubled(cells.vertices.size(), 0);
  for (size_t edge = 0; edge < cells.edges.size(); ++edge) {
    if (!tile.Doubled()[edge]) continue;
    ++doubled[static_cast<size_t>(cells.edges[edge].from)];
    ++doubled[static_cast<size_t>(cells.edges[edge].to)];
  }
  EXPECT_EQ(std::ranges::count(doubled, 1), std::ssize(doubled));
}

TEST(StrandTile, WalksEachEdgeOnceAndDoubledOnesTwice) {
  const VoronoiTile cells = RelaxedCells(kSide, 10);
  const StrandTile tile(cells);
  double asked = 0, got = 0, twice = 0;
  for (size_t edge = 0; edge < cells.edges.size(); ++edge) {
    asked += EdgeLength(cells, edge);
    if (tile.Doubled()[edge]) twice += EdgeLength(cells, edge);
  }
  for (const Strand& strand : tile.Strands(0))
    for (size_t i = 1; i < 4; ++i) got += Between(strand.points[i - 1], strand.points[i]);
  EXPECT_NEAR(got, asked + twice, 1e-9);
  // A third of all edges are doubled, and the matching prefers short edges.
  EXPECT_LT(twice, 0.3 * asked);
}

TEST(StrandTile, IsOneCurve) {
  const StrandTile tile(RelaxedCells(kSide, 10));
  const auto strands = tile.Strands(0.01);
  std::set<int32_t> met;
  int32_t strand = 0, end = 0;
  do {
    met.insert(strand);
    const Strand& at = strands[static_cast<size_t>(strand)];
    const Strand::Next next = at.next[static_cast<size_t>(end ^ 1)];
    const Vector2 out = at.points[end == 0 ? 3 : 0];
    const Vector2 in = strands[static_cast<size_t>(next.strand)].points[next.end == 0 ? 0 : 3];
    EXPECT_NEAR(out.x(), in.x() + next.step_u, 1e-12);
    EXPECT_NEAR(out.y(), in.y() + next.step_v, 1e-12);
    strand = next.strand, end = next.end;
  } while (strand != 0 || end != 0);
  EXPECT_EQ(met.size(), strands.size());
  EXPECT_LT(tile.Crossings(), kSide * kSide / 4);
}

// The lines of a doubled edge are a gap apart unless they cross.
TEST(StrandTile, DoubledLinesKeepTheirGap) {
  const StrandTile tile(RelaxedCells(kSide, 20));
  constexpr double kGap = 0.01;
  const auto strands = tile.Strands(kGap);
  int apart = 0;
  for (size_t i = 0; i + 1 < strands.size(); i += 2) {
    const Vector2 a = strands[i].points[1], b = strands[i].points[2], p = strands[i + 1].points[1];
    const double length = Between(a, b);
    if (length < kGap) continue;
    const double aside =
        std::abs((b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x())) / length;
    if (std::abs(aside - kGap) < 1e-3 * kGap) ++apart;
  }
  EXPECT_GT(apart, 0.7 * static_cast<double>(strands.size()) / 2);
}

}  // namespace
}  // namespace slicefarm::infill::cell_strands_test
