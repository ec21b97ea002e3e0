#include "services/infill/algo/lines/scan_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::scan_lines_test {
namespace {

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }

double TotalMm(const ScanLines& lines) { return lines.TotalLength() / kNmPerMm; }

TEST(ScanLines, CutASquare) {
  const MultiPolygon square = P("(0 0, 10 0, 10 10, 0 10)");
  const auto lines = CutLines(square, {0, 0.5e6, 1e6});
  ASSERT_TRUE(lines.ok());
  EXPECT_EQ(lines->LineCount(), 10);
  EXPECT_EQ(lines->PieceCount(), 10);
  EXPECT_NEAR(lines->PieceLength(3), 10e6, 1e-3);
  EXPECT_NEAR(TotalMm(*lines), 100, 1e-9);
  EXPECT_EQ(lines->PointOf(lines->crossings[lines->order[0]]), (Point{0, 500'000}));
}

// Every line through vertices and along edges still meets the boundary an even number of times.
TEST(ScanLines, ThroughVerticesAndAlongEdges) {
  const MultiPolygon region =
      P("(0 0, 4 0, 4 2, 6 2, 6 1, 8 1, 8 4, 5 6, 2 4, 0 4) (1 1, 3 1, 2 3)");
  for (const double angle : {0.0, std::numbers::pi / 2, std::numbers::pi / 4, 0.3, -1.1}) {
    const auto lines = CutLines(region, {angle, 0, 0.5e6});
    ASSERT_TRUE(lines.ok());
    for (int32_t line = 0; line < lines->LineCount(); ++line)
      EXPECT_EQ((lines->line_begin[line + 1] - lines->line_begin[line]) % 2, 0) << line;
    EXPECT_NEAR(TotalMm(*lines) * 0.5, Area(region) / 1e12, 1.2) << angle;
  }
}

TEST(ScanLines, FineLinesMeasureTheArea) {
  const MultiPolygon region = P("(0 0, 7 1, 9 6, 3 8) (3 3, 5 3, 4 5) ; (20 0, 21 0, 20 3)");
  const auto lines = CutLines(region, {0.7, 0, 1e4});
  ASSERT_TRUE(lines.ok());
  EXPECT_NEAR(TotalMm(*lines) * 0.01, Area(region) / 1e12, 1e-3);
}

TEST(ScanLines, CrossingsFormCyclesAlongTheRings) {
  const MultiPolygon region = P("(0 0, 10 0, 10 10, 0 10) (3 3, 7 3, 7 7, 3 7)");
  const auto lines = CutLines(region, {0.4, 0, 0.7e6});
  ASSERT_TRUE(lines.ok());
  for (size_t i = 0; i < lines->crossings.size(); ++i) {
    const Crossing& crossing = lines->crossings[i];
    EXPECT_EQ(lines->crossings[crossing.next].previous, static_cast<int32_t>(i));
    EXPECT_EQ(lines->crossings[crossing.next].ring, crossing.ring);
    EXPECT_LE(std::abs(lines->crossings[crossing.next].line - crossing.line), 1);
    EXPECT_EQ(lines->order[crossing.place], static_cast<int32_t>(i));
  }
}

TEST(ScanLines, NoLinesInNothing) {
  const MultiPolygon none;
  const auto lines = CutLines(none, {0, 0, 1e6});
  ASSERT_TRUE(lines.ok());
  EXPECT_EQ(lines->LineCount(), 0);
  const MultiPolygon flat = P("(0 0.1, 10 0.1, 10 0.9, 0 0.9)");
  EXPECT_EQ(CutLines(flat, {0, 0, 1e6})->PieceCount(), 0);
}

TEST(ScanLines, RefusesTooMany) {
  const MultiPolygon square = P("(0 0, 1000 0, 1000 1000, 0 1000)");
  const auto lines = CutLines(square, {0, 0, 1e3});
  EXPECT_EQ(DetailOf(lines.status()).reason, Reason::kRequestTooLarge);
  EXPECT_EQ(DetailOf(lines.status()).metadata.at("got"), "1000000");
}

}  // namespace
}  // namespace slicefarm::infill::scan_lines_test
