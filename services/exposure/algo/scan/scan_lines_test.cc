#include "services/exposure/algo/scan/scan_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::exposure::scan_lines_test {
namespace {

TEST(CutScanLines, OfASquareWithAHole) {
  const auto pieces =
      CutScanLines(MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10) (4 4, 6 4, 6 6, 4 6)"), LineAxes(0),
                   {.pitch_nm = 1e6, .phase = 0.5});
  ASSERT_TRUE(pieces.ok());
  ASSERT_EQ(pieces->size(), 12u);
  EXPECT_EQ((*pieces)[0].line, 0);
  EXPECT_EQ((*pieces)[4].line, 4);
  EXPECT_EQ((*pieces)[4].u1, 4e6);
  EXPECT_EQ((*pieces)[5].line, 4);
  EXPECT_EQ((*pieces)[5].u0, 6e6);
}

TEST(CutScanLines, LinesThroughCornersMeetARingAnEvenNumberOfTimes) {
  // All corners are on lines.
  const auto pieces = CutScanLines(MakePolygonsOrDie("(0 0, 3 1, 6 0, 6 4, 3 2, 0 4)"), LineAxes(0),
                                   {.pitch_nm = 1e6});
  ASSERT_TRUE(pieces.ok());
  double length = 0;
  for (const ScanPiece& piece : *pieces) length += piece.u1 - piece.u0;
  EXPECT_NEAR(length, 15e6 - 3e6, 3e6);
  for (const ScanPiece& piece : *pieces) EXPECT_LT(piece.u0, piece.u1);
}

/// The middles of pieces are inside and the middles of gaps between them outside, at any angle.
TEST(CutScanLines, PiecesAreWhatIsInside) {
  std::mt19937 random(9);
  for (int i = 0; i < 200; ++i) {
    const MultiPolygon region = RandomIsland(random, {i * 1000, 7}, 8);
    const LineAxes frame = LineAxes::OfDegrees(Uniform(random, -720, 720));
    const LineGrid grid{.pitch_nm = 333'333, .phase = 0.5};
    const auto pieces = CutScanLines(region, frame, grid);
    ASSERT_TRUE(pieces.ok());
    const ScanPiece* before = nullptr;
    for (const ScanPiece& piece : *pieces) {
      const double v = grid.V(piece.line);
      const Point middle = frame.At((piece.u0 + piece.u1) / 2, v);
      EXPECT_TRUE(piece.u1 - piece.u0 <= 4 || Inside(middle, region));
      if (before != nullptr && before->line == piece.line && piece.u0 - before->u1 > 4) {
        const Point gap = frame.At((before->u1 + piece.u0) / 2, v);
        EXPECT_FALSE(Inside(gap, region));
      }
      before = &piece;
    }
  }
}

TEST(CutScanLines, RefusesTooMany) {
  const auto pieces = CutScanLines(MakePolygonsOrDie("(0 0, 1000 0, 1000 1000, 0 1000)"),
                                   LineAxes(0), {.pitch_nm = 10});
  EXPECT_EQ(DetailOf(pieces.status()).reason, Reason::kRequestTooLarge);
}

using Ends = std::vector<std::pair<double, double>>;

/// Returns the ends of the line through the middle of the region's height, in mm.
Ends MiddleOf(const HatchRegion& region) {
  const auto pieces =
      CutTrimmedLines(region, LineAxes::OfDegrees(0), {.pitch_nm = 100e6, .phase = 0.05});
  EXPECT_TRUE(pieces.ok());
  Ends ends;
  for (const ScanPiece& piece : *pieces) ends.push_back({piece.u0 / 1e6, piece.u1 / 1e6});
  return ends;
}

TEST(CutTrimmedLines, EndBeforeTheBorderOfTheWholeAlone) {
  const MultiPolygon whole =
      MakePolygonsOrDie("(0 0, 20 0, 20 10, 0 10); (30 0, 40 0, 40 10, 30 10)");
  const MultiPolygon part = MakePolygonsOrDie("(0 0, 8 0, 8 10, 0 10); (18 0, 35 0, 35 10, 18 10)");
  EXPECT_EQ(MiddleOf({.area = whole, .trim_nm = 1e6}), (Ends{{1, 19}, {31, 39}}));
  EXPECT_EQ(MiddleOf({.area = part, .whole = whole, .trim_nm = 1e6}),
            (Ends{{1, 8}, {18, 19}, {31, 35}}));
  EXPECT_EQ(MiddleOf({.area = part, .whole = whole}), (Ends{{0, 8}, {18, 35}}));
}

TEST(CutTrimmedLines, ShortPiecesLoseAQuarterAtEitherEndAndTheShortestGo) {
  const MultiPolygon area = MakePolygonsOrDie(
      "(0 0, 4 0, 4 10, 0 10); (10 0, 12 0, 12 10, 10 10); (20 0, 21 0, 21 10, 20 10)");
  EXPECT_EQ(MiddleOf({.area = area, .trim_nm = 1.5e6}), (Ends{{1, 3}, {10.5, 11.5}}));
}

TEST(CutTrimmedLines, NothingInNarrowParts) {
  const MultiPolygon area =
      MakePolygonsOrDie("(0 0, 20 0, 20 10, 0 10); (30 0, 40 0, 40 10, 30 10)");
  const MultiPolygon narrow = MakePolygonsOrDie(
      "(-1 0, 2 0, 2 10, -1 10); (5 0, 6 0, 6 10, 5 10); (18 0, 33 0, 33 10, 18 10)");
  EXPECT_EQ(MiddleOf({.area = area, .narrow = narrow}), (Ends{{2, 5}, {6, 18}, {33, 40}}));
  EXPECT_EQ(MiddleOf({.area = area, .narrow = area}), Ends{});
}

}  // namespace
}  // namespace slicefarm::exposure::scan_lines_test
