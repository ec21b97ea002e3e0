#include "services/infill/algo/axis/main_axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "common/base/portable_math.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::main_axis_test {
namespace {

PolygonWithHoles P(std::string_view text) { return MakePolygonsOrDie(text)[0]; }

Polygon Ngon(double radius_mm, int corners) {
  Polygon ring;
  for (int i = 0; i < corners; ++i) {
    const double turn = 2 * std::numbers::pi * i / corners;
    ring.push_back({FromMm(radius_mm * Cos(turn)), FromMm(radius_mm * Sin(turn))});
  }
  return ring;
}

double TotalMm(const std::vector<Polyline>& lines) {
  double length = 0;
  for (const Polyline& line : lines) length += Length(line);
  return ToMm(length);
}

TEST(MainAxis, OfAStripRunsAlongItAndIntoItsCorners) {
  const auto lines = MainAxis(P("(0 0, 60 0, 60 10, 0 10)"), {});
  EXPECT_NEAR(TotalMm(lines), 50 + 4 * 5 * std::numbers::sqrt2, 0.1);
  // The axis has two forks: its five edges are three lines.
  EXPECT_EQ(lines.size(), 3u);
}

TEST(MainAxis, LeavesOutCornersOfARoundOutline) {
  const auto disc = MainAxis({Ngon(20, 90), {}}, {});
  ASSERT_EQ(disc.size(), 1u);
  EXPECT_LE(Length(disc[0]), 1'000);
  EXPECT_LE(Distance(disc[0][0], Point{0, 0}), 200'000);
  EXPECT_EQ(MainAxis({Ngon(20, 4), {}}, {}).size(), 2u) << "square corners are none of these";
}

TEST(MainAxis, LeavesOutWhatASmallNotchMakes) {
  const double plain = TotalMm(MainAxis(P("(0 0, 60 0, 60 20, 0 20)"), {}));
  const double notched =
      TotalMm(MainAxis(P("(0 0, 30 0, 30.2 -0.8, 30.4 0, 60 0, 60 20, 0 20)"), {}));
  EXPECT_NEAR(notched, plain, 0.1);
}

TEST(MainAxis, GoesAroundHoles) {
  Polygon hole = Ngon(10, 90);
  std::ranges::reverse(hole);
  const auto lines = MainAxis({Ngon(20, 90), {hole}}, {});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].front(), lines[0].back());
  for (const Point p : lines[0]) EXPECT_NEAR(ToMm(Distance(p, Point{0, 0})), 15, 0.05);
}

TEST(MainAxis, TurnsWithTheIsland) {
  const PolygonWithHoles shape = P("(0 0, 50 3, 47 31, 20 40, 22 20, -4 18) (8 6, 9 12, 14 10)");
  PolygonWithHoles turned = shape;
  for (Polygon* ring : {&turned.outer, turned.holes.data()})
    for (Point& p : *ring) p = {-p.y, p.x};
  std::rotate(turned.outer.begin(), turned.outer.begin() + 2, turned.outer.end());
  EXPECT_NEAR(TotalMm(MainAxis(shape, {})), TotalMm(MainAxis(turned, {})), 0.05);
}

TEST(MainAxis, OfWhatHasNoDiagramIsTheMiddleOfItsBox) {
  // A ring that crosses itself.
  const auto lines =
      MainAxis({{{0, 0}, {40'000'000, 9'000'000}, {40'000'000, 0}, {0, 9'000'000}}, {}}, {});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0], (Polyline{{0, 4'500'000}, {40'000'000, 4'500'000}}));
}

}  // namespace
}  // namespace slicefarm::infill::main_axis_test
