#include "services/infill/algo/lines/rounded_corners.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::rounded_corners_test {
namespace {

const MultiPolygon& Square() {
  static const MultiPolygon square = MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20)");
  return square;
}

/// Returns a line that turns by a right angle in (10, 10).
std::vector<Piece> Angle() {
  return {{.points = {{0, 10'000'000}, {10'000'000, 10'000'000}, {10'000'000, 0}}}};
}

TEST(RoundCorners, CornersBecomeParabolas) {
  auto pieces = Angle();
  RoundCorners(Square(), 1, pieces);
  const Polyline& line = pieces[0].points;
  EXPECT_EQ(line.front(), (Point{0, 10'000'000}));
  EXPECT_EQ(line.back(), (Point{10'000'000, 0}));
  EXPECT_EQ(line[1], (Point{5'000'000, 10'000'000}));
  EXPECT_EQ(line[line.size() - 2], (Point{10'000'000, 5'000'000}));
  // A parabola with two legs of 1 has the length 1.623.
  EXPECT_NEAR(Length(line) / 1e6, 10 + 5 * 1.6232, 0.01);
  for (size_t i = 1; i + 1 < line.size(); ++i) {
    const Point in = line[i] - line[i - 1], out = line[i + 1] - line[i];
    EXPECT_GT(Dot(in, out), 0.97 * Norm(in) * Norm(out)) << "turns little at point " << i;
  }
}

TEST(RoundCorners, TheShareIsOfHalfAnEdge) {
  for (const double share : {0.2, 0.5}) {
    auto pieces = Angle();
    RoundCorners(Square(), share, pieces);
    EXPECT_EQ(pieces[0].points[1], (Point{std::llround(1e7 - 5e6 * share), 10'000'000})) << share;
  }
}

TEST(RoundCorners, ClosedLinesStayClosed) {
  std::vector<Piece> pieces = {
      {.points = MakePolygonsOrDie("(5 5, 15 5, 15 15, 5 15)")[0].outer, .closed = true}};
  RoundCorners(Square(), 1, pieces);
  EXPECT_NE(pieces[0].points.front(), pieces[0].points.back());
  EXPECT_NEAR(SignedArea(pieces[0].points) / 1e12, 100 - 4 * 25.0 / 6, 0.3);
}

// Hairpins, straight points and corners around a corner of the region stay.
TEST(RoundCorners, SomeCornersStay) {
  std::vector<Piece> pieces = {{.points = {{0, 0}, {10'000'000, 0}, {0, 500'000}}},
                               {.points = {{0, 0}, {5'000'000, 0}, {10'000'000, 100'000}}}};
  const auto before = pieces;
  RoundCorners(Square(), 1, pieces);
  for (size_t i = 0; i < pieces.size(); ++i) EXPECT_EQ(pieces[i].points, before[i].points);
  auto around = Angle();
  RoundCorners(MakePolygonsOrDie("(0 9, 9 9, 9 0, 20 0, 20 20, 0 20)"), 1, around);
  EXPECT_EQ(around[0].points, Angle()[0].points);
}

/// Returns true if the right angle becomes a parabola in a square with a hole of 0.3 mm.
bool IsRoundedWithHoleAt(double x_mm, double y_mm) {
  const Coord x = FromMm(x_mm), y = FromMm(y_mm), half = 150'000;
  MultiPolygon region = Square();
  region[0].holes = {
      {{x - half, y - half}, {x - half, y + half}, {x + half, y + half}, {x + half, y - half}}};
  auto pieces = Angle();
  RoundCorners(region, 1, pieces);
  return pieces[0].points != Angle()[0].points;
}

TEST(RoundCorners, NoParabolaCrossesAHole) {
  EXPECT_FALSE(IsRoundedWithHoleAt(8.75, 8.75)) << "on the middle of the parabola";
  EXPECT_FALSE(IsRoundedWithHoleAt(6.4, 9.8)) << "near its start";
  EXPECT_TRUE(IsRoundedWithHoleAt(9.6, 9.6)) << "between it and the corner";
  EXPECT_TRUE(IsRoundedWithHoleAt(7.5, 7.5)) << "on its chord";
}

}  // namespace
}  // namespace slicefarm::infill::rounded_corners_test
