#include "services/infill/algo/linking/serpentine.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/geometry/text_format_test.h"
#include "common/model/paths_test.h"

namespace slicefarm::infill::serpentine_test {
namespace {

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }

std::vector<Polyline> Paths(const MultiPolygon& region, const LineFamily& family, bool monotonic,
                            double max_link_mm = 3) {
  const auto lines = CutLines(region, family);
  std::vector<Polyline> paths;
  for (SerpentinePath& path :
       Serpentine(*lines, {.monotonic = monotonic, .max_link_nm = max_link_mm * kNmPerMm}))
    paths.push_back(std::move(path.points));
  return paths;
}

TEST(Serpentine, ConvexRegionIsOnePath) {
  for (const bool monotonic : {false, true}) {
    const MultiPolygon square = P("(0 0, 10 0, 10 10, 0 10)");
    const auto paths = Paths(square, {0, 0.5e6, 1e6}, monotonic);
    ASSERT_EQ(paths.size(), 1u);
    EXPECT_NEAR(TotalMm(paths), 109, 1e-6);
    EXPECT_EQ(paths[0].size(), 20u);
    const MultiPolygon disc = P("(0 0, 4 -1, 8 0, 9 4, 8 8, 4 9, 0 8, -1 4)");
    EXPECT_EQ(Paths(disc, {0.6, 0, 0.4e6}, monotonic).size(), 1u);
  }
}

TEST(Serpentine, TellsPiecesFromLinks) {
  const MultiPolygon region = P("(0 0, 10 0, 11 1, 10 2, 0 2)");
  const auto lines = CutLines(region, {0, 0.5e6, 1e6});
  const auto paths = Serpentine(*lines, {.max_link_nm = 3e6});
  ASSERT_EQ(paths.size(), 1u);
  ASSERT_EQ(paths[0].pieces.size(), 2u);
  for (const int32_t i : paths[0].pieces) EXPECT_EQ(paths[0].points[i].y, paths[0].points[i + 1].y);
  EXPECT_EQ(paths[0].pieces[1], 3);  // the link's corner is between
}

TEST(Serpentine, LinksFollowTheBoundary) {
  const MultiPolygon region = P("(0 0, 10 0, 11 1, 10 2, 0 2)");
  const auto paths = Paths(region, {0, 0.5e6, 1e6}, false);
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_TRUE(std::count(paths[0].begin(), paths[0].end(), Point{11'000'000, 1'000'000}));
}

// The left end of the lowest line is near the next line's end, and its right end is far from it. So
// the path begins at the right end.
TEST(Serpentine, BeginsWhereTheOtherEndLeadsOn) {
  const MultiPolygon pocket = P("(0 0, 2 0, 8 1, 8 2, 0 2)");
  for (const bool monotonic : {false, true}) {
    const auto paths = Paths(pocket, {0, 0.2e6, 1e6}, monotonic, 1.5);
    ASSERT_EQ(paths.size(), 1u);
    EXPECT_EQ(paths[0][0], (Point{3'200'000, 200'000}));
  }
}

// Two tips are below one body. Neither may be left for later, and the boundary connects them
// without meeting another line.
TEST(Serpentine, TipsOfOneLineAreJoinedAlongTheNotch) {
  const MultiPolygon notched = P("(0 0, 2 0, 3 0.9, 4 0, 6 0, 6 3, 0 3)");
  for (const bool monotonic : {false, true}) {
    const auto paths = Paths(notched, {0, 0.5e6, 1e6}, monotonic);
    ASSERT_EQ(paths.size(), 1u) << monotonic;
    EXPECT_TRUE(std::count(paths[0].begin(), paths[0].end(), Point{3'000'000, 900'000}));
  }
  EXPECT_GT(Paths(notched, {0, 0.5e6, 1e6}, true, 1.1).size(), 1u);
}

TEST(Serpentine, LinesGoOnAroundASmallHole) {
  const MultiPolygon holed = P("(0 0, 6 0, 6 3, 0 3) (3 1.1, 3.3 1.45, 3 1.8, 2.7 1.45)");
  const auto paths = Paths(holed, {0, 0.5e6, 1e6}, true);
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_EQ(paths[0].size(), 9u);
}

// Pieces in a slanted spike are not beside each other, but each is linked to the next.
TEST(Serpentine, SlantedSpikeIsOnePath) {
  const MultiPolygon spike = P("(0 0, 10.3 5, 10 5.5)");
  for (const double angle : {0.0, 1.2, 2.4, 5.0})
    EXPECT_EQ(Paths(spike, {angle, 0.1e6, 0.4e6}, true).size(), 1u) << angle;
}

TEST(Serpentine, LongLinksAreLeftToTravel) {
  const MultiPolygon square = P("(0 0, 10 0, 10 10, 0 10)");
  EXPECT_EQ(Paths(square, {0, 0.5e6, 1e6}, false, 0.9).size(), 10u);
}

// No piece is omitted or printed twice, for any shape.
TEST(Serpentine, UsesEveryPieceOnce) {
  const MultiPolygon region =
      P("(0 0, 20 0, 20 10, 0 10) (3 3, 6 3, 6 6, 3 6) (9 1, 11 1, 11 9, 9 9) (14 4, 16 2, 18 4, "
        "16 6)");
  for (const bool monotonic : {false, true}) {
    for (const double angle : {0.0, 0.5, 1.5}) {
      const auto lines = CutLines(region, {angle, 0, 0.31e6});
      const auto paths = Paths(region, {angle, 0, 0.31e6}, monotonic, 0);
      ASSERT_EQ(paths.size(), static_cast<size_t>(lines->PieceCount()));
      EXPECT_NEAR(TotalMm(paths), lines->TotalLength() / kNmPerMm, 1e-3);
    }
  }
}

// Each point's piece is printed after the pieces beside it on the line below. Therefore v never
// decreases within a path, and a path starts only above printed pieces.
TEST(Serpentine, MonotonicRisesEverywhere) {
  const MultiPolygon region =
      P("(0 0, 20 0, 20 10, 0 10) (3 3, 6 3, 6 6, 3 6) (9 1, 11 1, 11 9, 9 9) (14 4, 16 2, 18 4, "
        "16 6)");
  const auto paths = Paths(region, {0, 0.2e6, 0.4e6}, true);
  EXPECT_LT(paths.size(), 12u);
  struct Piece {
    Coord left, right, y;
  };
  std::vector<Piece> printed;
  for (const Polyline& path : paths) {
    for (size_t i = 1; i < path.size(); ++i) {
      if (path[i].y != path[i - 1].y || (path[i].y - 200'000) % 400'000 != 0) continue;
      const auto [left, right] = std::minmax(path[i].x, path[i - 1].x);
      for (const Piece& earlier : printed) {
        const bool beside = earlier.left < right && left < earlier.right;
        EXPECT_FALSE(beside && earlier.y == path[i].y + 400'000) << ToText(path[i]);
      }
      printed.push_back({left, right, path[i].y});
    }
  }
}

TEST(Serpentine, ShortPathsAreLeftOut) {
  const MultiPolygon region = P("(0 0, 0.3 0, 0.3 10, 0 10)");
  const auto lines = CutLines(region, {0, 0, 1e6});
  EXPECT_TRUE(Serpentine(*lines, {.max_link_nm = 0, .min_length_nm = 0.45e6}).empty());
}

}  // namespace
}  // namespace slicefarm::infill::serpentine_test
