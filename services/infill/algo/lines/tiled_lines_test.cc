#include "services/infill/algo/lines/tiled_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::tiled_lines_test {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

LevelLine Circle(double radius, int points) {
  LevelLine line;
  for (int i = 0; i < points; ++i)
    line.points.push_back(
        {0.5 + radius * std::cos(kTurn * i / points), 0.5 + radius * std::sin(kTurn * i / points)});
  return line;
}

double LengthOf(const LevelLine& line) {
  double length = 0;
  const size_t count = line.points.size() - (line.IsClosed() ? 0 : 1);
  for (size_t i = 0; i < count; ++i) {
    const Vector2 a = line.points[i], b = line.points[(i + 1) % line.points.size()];
    length += std::hypot(b.x() - a.x(), b.y() - a.y());
  }
  return length;
}

TEST(LongSegments, KeepLengthAndTolerance) {
  const LevelLine fine = Circle(0.3, 500);
  for (const double tolerance : {0.002, 0.01, 0.02}) {
    const LevelLine line = WithLongSegments(fine, tolerance);
    EXPECT_LT(line.points.size(), 26u);
    EXPECT_NEAR(LengthOf(line) / LengthOf(fine), 1, 0.004);
    for (size_t i = 0; i < line.points.size(); ++i) {
      const Vector2 a = line.points[i], b = line.points[(i + 1) % line.points.size()];
      for (const double t : {0.0, 0.25, 0.5, 0.75}) {
        const double u = a.x() + t * (b.x() - a.x()) - 0.5, v = a.y() + t * (b.y() - a.y()) - 0.5;
        EXPECT_NEAR(std::hypot(u, v), 0.3, 1.2 * tolerance);
      }
    }
  }
}

TEST(LongSegments, OpenLinesGoOn) {
  LevelLine wave{{}, 1, 0};
  for (int i = 0; i <= 200; ++i)
    wave.points.push_back({i / 200.0, 0.2 * std::sin(kTurn * i / 200)});
  const LevelLine line = WithLongSegments(wave, 0.01);
  EXPECT_LT(line.points.size(), 12u);
  EXPECT_NEAR(LengthOf(line) / LengthOf(wave), 1, 0.004);
  EXPECT_NEAR(line.points.back().x() - line.points.front().x(), 1, 1e-12);
  EXPECT_NEAR(line.points.back().y(), line.points.front().y(), 1e-12);
}

/// The length within a box of whole periods is a period's length times the number of periods.
TEST(TiledLines, CoverEveryPeriodOnce) {
  const MultiPolygon box = MakePolygonsOrDie("(-12 -8, 20 -8, 20 16, -12 16)");
  const double period = 4e6, periods = 8 * 6;
  LevelLine straight{{{0, 0.25}, {1, 0.25}}, 1, 0};
  LevelLine back{{{1, 0.75}, {0, 0.75}}, -1, 0};
  LevelLine up{{{0.3, 0}, {0.3, 1}}, 0, 1};
  LevelLine slanted{{{0.1, 0.2}, {1.1, 2.2}}, 1, 2};
  LevelLine falling{{{0.1, 0.2}, {3.1, -1.8}}, 3, -2};
  struct Case {
    const char* name;
    LevelLine line;
    size_t curves;  // number of curves inside the box
    double length;
  };
  const Case cases[] = {{"Straight", straight, 6, 1},
                        {"Back", back, 6, 1},
                        {"Up", up, 8, 1},
                        {"Slanted", slanted, 0, std::sqrt(5)},
                        {"Falling", falling, 0, std::sqrt(13)},
                        {"Circle", Circle(0.3, 40), 48, LengthOf(Circle(0.3, 40))}};
  for (const Case& c : cases) {
    const auto curves = TiledLines(box, {&c.line, 1}, LineAxes(0), period);
    ASSERT_TRUE(curves.ok());
    const auto pieces = ClipCurves(box, *curves);
    if (c.curves > 0) {
      EXPECT_EQ(pieces.size(), c.curves) << c.name;
    }
    double length = 0;
    for (const Piece& piece : pieces)
      length += piece.closed ? Perimeter(piece.points) : Length(piece.points);
    EXPECT_NEAR(length / (c.length * period * periods), 1, 1e-4) << c.name;
  }
}

TEST(TiledLines, TooManyAreRefused) {
  const MultiPolygon box = MakePolygonsOrDie("(0 0, 100 0, 100 100, 0 100)");
  const LevelLine circle = Circle(0.3, 8);
  const auto curves = TiledLines(box, {&circle, 1}, LineAxes(0), 1e5);
  EXPECT_EQ(DetailOf(curves.status()).reason, Reason::kRequestTooLarge);
}

}  // namespace
}  // namespace slicefarm::infill::tiled_lines_test
