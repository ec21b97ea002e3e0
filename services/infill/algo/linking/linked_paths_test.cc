#include "services/infill/algo/linking/linked_paths.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "services/infill/algo/bead_checks_test.h"
#include "services/infill/algo/lines/straight_pieces.h"

namespace slicefarm::infill::linked_paths_test {
namespace {

MultiPolygon Region() {
  return MakePolygonsOrDie(
      "(0 0, 20 0, 20 10, 0 10) (3 3, 3 6, 6 6, 6 3) (9 1, 9 9, 11 9, 11 1) ; (30 0, 40 3, 31 9)");
}

std::vector<Piece> Lines(double angle) {
  const LineFamily families[] = {{angle, 0, 2.1e6}, {angle + 1.5, 0, 2.3e6}};
  return *StraightPieces(Region(), families);
}

double LengthOf(const std::vector<Piece>& pieces) {
  double length = 0;
  for (const Piece& piece : pieces) length += Length(piece.points);
  return length;
}

double LengthOf(const std::vector<Path>& paths) {
  double length = 0;
  for (const Path& path : paths) length += PathLength(path);
  return length;
}

/// Checks properties of all paths: one width, and no bead on another bead.
void ExpectEvenBeads(const std::vector<Path>& paths) {
  for (const Path& path : paths) {
    EXPECT_TRUE(WellFormed(path));
    EXPECT_EQ(path.widths_nm, std::vector<Coord>{450'000});
  }
  EXPECT_LE(DoubledLength(paths, 450'000), 0.006 * LengthOf(paths));
}

TEST(LinkedPaths, HoldToTheEdgeByEvenBeads) {
  for (const double angle : {0.0, 0.03, 0.5, 1.2}) {
    const std::vector<Piece> pieces = Lines(angle);
    const auto paths = LinkedPaths(Region(), pieces, {.max_link_nm = 50e6, .anchor_nm = 2.7e6});
    ExpectEvenBeads(paths);
    double edge = 0;
    ForEachRing(Region(), [&edge](const Polygon& ring) { edge += Perimeter(ring); });
    EXPECT_GE(LengthAlongEdge(paths, Region(), 10'000), 0.4 * edge) << angle;
    EXPECT_LE(paths.size(), 6u) << angle;
  }
}

// The line is so near to a side of the box that a bead along this side would overlap it.
TEST(LinkedPaths, NoLinkLiesOnALine) {
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)");
  for (const double angle : {0.0, 0.01, -0.02}) {
    for (const double first : {0.05e6, 0.15e6, 0.25e6}) {
      const LineFamily families[] = {{angle, first, 2e6}, {angle + 1.57, 1e6, 2e6}};
      const auto pieces = StraightPieces(square, families);
      const auto paths = LinkedPaths(square, *pieces, {.max_link_nm = 50e6, .anchor_nm = 2.7e6});
      ExpectEvenBeads(paths);
      EXPECT_GE(LengthAlongEdge(paths, square, 10'000), 0.3 * 40e6) << angle << ' ' << first;
    }
  }
}

// The link begins beside its own line: the line ends where the link leaves it.
TEST(LinkedPaths, ALineInAWedgeIsCutOffThere) {
  const MultiPolygon wedge = MakePolygonsOrDie("(0 0, 20 0, 20 8, 0 8)");
  const LineFamily family{0.08, 0, 1.5e6};
  const auto pieces = StraightPieces(wedge, {&family, 1});
  const auto paths = LinkedPaths(wedge, *pieces, {.max_link_nm = 50e6, .anchor_nm = 2.7e6});
  EXPECT_LE(paths.size(), 2u);
  ExpectEvenBeads(paths);
}

TEST(LinkedPaths, WithoutLinksAreThePieces) {
  const std::vector<Piece> pieces = Lines(0.3);
  const auto paths = LinkedPaths(Region(), pieces, {.max_link_nm = 0});
  ASSERT_EQ(paths.size(), pieces.size());
  EXPECT_NEAR(LengthOf(paths), LengthOf(pieces), 1);
}

TEST(LinkedPaths, LinksAreAsWideAsLines) {
  const LineFamily family{0, 0.5e6, 1e6};
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)");
  const auto pieces = StraightPieces(square, {&family, 1});
  const auto paths = LinkedPaths(square, *pieces, {.max_link_nm = 50e6});
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_EQ(paths[0].widths_nm.size(), 1u);
  EXPECT_NEAR(PathLength(paths[0]), 109e6, 1);
}

TEST(LinkedPaths, CrossingLinesAreOneRingInAnyConnectedRegion) {
  const MultiPolygon regions[] = {
      MakePolygonsOrDie("(0 0, 30 0, 30 20, 0 20)"),
      MakePolygonsOrDie("(0 0, 30 0, 30 20, 0 20) (8 8, 8 12, 12 12, 12 8) (20 5, 20 9, 25 9)")};
  for (const MultiPolygon& region : regions) {
    for (const double angle : {0.3, 0.5, 1.2}) {
      const LineFamily families[] = {{angle, 0, 2.1e6}, {angle + 1.5, 0, 2.3e6}};
      const auto pieces = *StraightPieces(region, families);
      const LinkOptions options{.max_link_nm = 50e6};
      const auto paths = LinkedPaths(region, pieces, options);
      ASSERT_EQ(paths.size(), 1u) << angle;
      EXPECT_TRUE(paths[0].closed);
      EXPECT_GE(LengthOf(paths), LengthOf(pieces));
    }
  }
}

TEST(LinkedPaths, LooseEndsTurnAlongTheEdge) {
  const LineFamily family{0, 5e6, 10e6};
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)");
  const auto pieces = StraightPieces(square, {&family, 1});
  const auto paths = LinkedPaths(square, *pieces, {.max_link_nm = 1e6, .anchor_nm = 2e6});
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_NEAR(PathLength(paths[0]), 14e6, 1);
}

TEST(LinkedPaths, ClosedPiecesStayClosed) {
  const std::vector<Piece> pieces = {{MakeLineOrDie("(14 4, 16 4, 16 6, 14 6)"), {}, {}, true}};
  const auto paths = LinkedPaths(Region(), pieces, {.max_link_nm = 50e6});
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_TRUE(paths[0].closed);
}

TEST(LinkedPaths, ShortPathsAreLeftOut) {
  const std::vector<Piece> pieces = {{MakeLineOrDie("(0 4, 0.4 4)"), {0, 3}, {}},
                                     {MakeLineOrDie("(0 5, 0.6 5)"), {0, 3}, {}}};
  EXPECT_EQ(LinkedPaths(Region(), pieces, {.min_length_nm = 0.5e6}).size(), 1u);
}

TEST(LinkedPaths, NothingOfNothing) { EXPECT_TRUE(LinkedPaths(Region(), {}, {}).empty()); }

}  // namespace
}  // namespace slicefarm::infill::linked_paths_test
