#include "services/infill/algo/linking/linked_paths.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/geometry/measure.h"
#include "common/geometry/text_format.h"
#include "common/model/bead_section.h"
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

/// Length in beads of the pieces' width: what the paths' plastic comes to.
double BeadsOf(const std::vector<Path>& paths, const LinkOptions& options) {
  double length = 0;
  for (const Path& path : paths) {
    EXPECT_TRUE(WellFormed(path));
    for (size_t i = 1; i < path.points.size(); ++i)
      length += Distance(path.points[i - 1], path.points[i]) *
                SectionMm2(path.WidthAt(i), options.height_nm) /
                SectionMm2(options.width_nm, options.height_nm);
  }
  return length;
}

TEST(LinkedPaths, KeepToTheBudget) {
  for (const double angle : {0.0, 0.5, 1.2}) {
    const std::vector<Piece> pieces = Lines(angle);
    const double length = LengthOf(pieces);
    size_t fewer = pieces.size() + 1;
    for (const double budget : {0.0, 2e6, 8e6, 40e6}) {
      const LinkOptions options{.max_link_nm = 50e6,
                                .anchor_nm = 2.7e6,
                                .most_cut_nm = 0.9e6,
                                .budget_nm = budget,
                                .most_flow = 0.6,
                                .least_flow = 0.3};
      const auto paths = LinkedPaths(Region(), pieces, options);
      EXPECT_LE(BeadsOf(paths, options), length + budget + 100) << angle << ' ' << budget;
      EXPECT_LE(paths.size(), fewer);
      fewer = paths.size();
    }
    EXPECT_LE(fewer, 5u);
  }
}

TEST(LinkedPaths, WithoutLinksAreThePieces) {
  const std::vector<Piece> pieces = Lines(0.3);
  const auto paths = LinkedPaths(Region(), pieces, {.max_link_nm = 0});
  ASSERT_EQ(paths.size(), pieces.size());
  EXPECT_NEAR(BeadsOf(paths, {}), LengthOf(pieces), 1);
}

TEST(LinkedPaths, FullWidthLinksHaveOneWidth) {
  const LineFamily family{0, 0.5e6, 1e6};
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)");
  const auto pieces = StraightPieces(square, {&family, 1});
  const auto paths = LinkedPaths(square, *pieces, {.max_link_nm = 50e6, .budget_nm = 1e9});
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_EQ(paths[0].widths_nm.size(), 1u);
  EXPECT_NEAR(PathLength(paths[0]), 109e6, 1);
}

TEST(LinkedPaths, CrossingLinesAreOneRingInAnyConnectedRegion) {
  const MultiPolygon regions[] = {
      MakePolygonsOrDie("(0 0, 30 0, 30 20, 0 20)"),
      MakePolygonsOrDie("(0 0, 30 0, 30 20, 0 20) (8 8, 8 12, 12 12, 12 8) (20 5, 20 9, 25 9)")};
  for (const MultiPolygon& region : regions) {
    for (const double angle : {0.1, 0.5, 1.2}) {
      const LineFamily families[] = {{angle, 0, 2.1e6}, {angle + 1.5, 0, 2.3e6}};
      const auto pieces = *StraightPieces(region, families);
      const LinkOptions options{.max_link_nm = 50e6, .budget_nm = 1e9};
      const auto paths = LinkedPaths(region, pieces, options);
      ASSERT_EQ(paths.size(), 1u) << angle;
      EXPECT_TRUE(paths[0].closed);
      EXPECT_GE(BeadsOf(paths, options), LengthOf(pieces) - 1);
    }
  }
}

TEST(LinkedPaths, LooseEndsTurnAlongTheEdge) {
  const LineFamily family{0, 5e6, 10e6};
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)");
  const auto pieces = StraightPieces(square, {&family, 1});
  const auto paths =
      LinkedPaths(square, *pieces, {.max_link_nm = 1e6, .anchor_nm = 2e6, .budget_nm = 1e9});
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_NEAR(PathLength(paths[0]), 14e6, 1);
}

TEST(LinkedPaths, ClosedPiecesStayClosed) {
  const std::vector<Piece> pieces = {{MakeLineOrDie("(14 4, 16 4, 16 6, 14 6)"), {}, {}, true}};
  const auto paths = LinkedPaths(Region(), pieces, {.max_link_nm = 50e6, .budget_nm = 1e9});
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
