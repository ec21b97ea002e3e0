#include "services/beading/algo/skeleton/medial_axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::beading::medial_axis_test {
namespace {

PolygonWithHoles Region(std::string_view text) { return MakePolygonsOrDie(text)[0]; }
std::vector<ThickLine> Of(std::string_view text) { return MedialAxis(Region(text), {}); }

double TotalLengthMm(const std::vector<ThickLine>& lines) {
  double length = 0;
  for (const ThickLine& line : lines) length += Length(line) / kNmPerMm;
  return length;
}

TEST(MedialAxis, OfAStripIsItsMiddle) {
  const auto lines = Of("(0 0, 10 0, 10 0.4, 0 0.4)");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].points.size(), 2u);
  EXPECT_FALSE(lines[0].closed);
  for (const Point p : lines[0].points) EXPECT_NEAR(p.y, 200'000, 1);
  for (const Coord t : lines[0].thickness_nm) EXPECT_NEAR(t, 400'000, 1);
  // The ends are closer to the short sides than half the width, but not beyond them.
  EXPECT_GT(TotalLengthMm(lines), 9.6);
  EXPECT_LE(TotalLengthMm(lines), 10);
}

TEST(MedialAxis, OfAWedgeGrowsFromTheTip) {
  const auto lines = Of("(0 0, 10 -0.4, 10 0.4)");
  ASSERT_EQ(lines.size(), 1u);
  const auto [thin, thick] =
      std::minmax_element(lines[0].thickness_nm.begin(), lines[0].thickness_nm.end());
  EXPECT_NEAR(*thin, 80'000, 2'000);  // no line where the wedge is narrower
  EXPECT_GT(*thick, 650'000);
}

TEST(MedialAxis, OfARingIsClosed) {
  const auto lines = Of("(0 0, 10 0, 10 10, 0 10) (0.5 0.5, 9.5 0.5, 9.5 9.5, 0.5 9.5)");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].closed);
  EXPECT_LE(lines[0].points.size(), 20u);
  EXPECT_NEAR(TotalLengthMm(lines), 38, 0.5);
}

TEST(MedialAxis, OfATeeIsTwoLines) {
  const auto lines = Of("(0 0, 10 0, 10 0.4, 5.2 0.4, 5.2 5, 4.8 5, 4.8 0.4, 0 0.4)");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NEAR(TotalLengthMm(lines), 14.4, 0.5);
  // The stem stops at the side of the bar instead of crossing it.
  const ThickLine& stem = Length(lines[0]) < Length(lines[1]) ? lines[0] : lines[1];
  Coord lowest = stem.points[0].y;
  for (const Point p : stem.points) lowest = std::min(lowest, p.y);
  EXPECT_GT(lowest, 300'000);
}

TEST(MedialAxis, OfACrossIsABarAndTwoArms) {
  const auto lines =
      Of("(4 0, 4.4 0, 4.4 4, 8 4, 8 4.4, 4.4 4.4, 4.4 8, 4 8, 4 4.4, 0 4.4, 0 4, 4 4)");
  EXPECT_EQ(lines.size(), 3u);
  EXPECT_NEAR(TotalLengthMm(lines), 15, 0.5);
}

TEST(MedialAxis, OfASquareIsADot) {
  const auto lines = Of("(0 0, 0.5 0, 0.5 0.5, 0 0.5)");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(Length(lines[0]), 200'000, 10'000);
  EXPECT_EQ(lines[0].thickness_nm[0], 500'000);
}

TEST(MedialAxis, NothingWhereTooThin) {
  EXPECT_TRUE(Of("(0 0, 10 0, 10 0.07, 0 0.07)").empty());
  // Only the wide half of a bottle is filled.
  const auto lines = Of("(0 0, 5 0, 5 -0.2, 10 -0.2, 10 0.25, 5 0.25, 5 0.05, 0 0.05)");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(TotalLengthMm(lines), 5, 0.4);
}

TEST(MedialAxis, AWidthStepDoesNotBreakTheLine) {
  EXPECT_EQ(Of("(0 0, 5 0, 5 -0.15, 10 -0.15, 10 0.45, 5 0.45, 5 0.3, 0 0.3)").size(), 1u);
}

/// Returns a ring 0.4 mm wide with a tooth every tenth of a mm, each just wide enough for a branch
/// of the axis.
PolygonWithHoles Gear(int teeth) {
  const double radius = teeth * 100'000 / (2 * std::numbers::pi);
  const auto at = [teeth](double tooth, double r) {
    const double turn = 2 * std::numbers::pi * tooth / teeth;
    return Point{std::llround(r * std::cos(turn)), std::llround(r * std::sin(turn))};
  };
  PolygonWithHoles region;
  Polygon& hole = region.holes.emplace_back();
  for (int i = 0; i < teeth; ++i) {
    region.outer.push_back(at(i, radius));
    region.outer.push_back(at(i + 0.42, radius + 70'000 + i % 43 * 1'000));
    region.outer.push_back(at(i + 0.84, radius));
    hole.push_back(at(teeth - i, radius - 400'000));
  }
  return region;
}

// The last case took 10 s when each pruned branch required a search along all others.
TEST(MedialAxis, ShortBranchesDoNotBreakALine) {
  for (const int teeth : {50, 1'000, 20'000}) {
    const auto lines = MedialAxis(Gear(teeth), {});
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(lines[0].closed);
    const double middle_mm = 0.1 * teeth - 2 * std::numbers::pi * 0.2;
    EXPECT_NEAR(TotalLengthMm(lines), middle_mm, middle_mm * 0.05);
  }
}

// The circles of a line stay in the region.
TEST(MedialAxis, LinesStayInside) {
  const PolygonWithHoles region = Region("(0 0, 6 0.3, 6 2, 5.5 2, 5.4 0.9, 0.4 0.6, 0.5 4, 0 4)");
  const auto lines = MedialAxis(region, {});
  ASSERT_FALSE(lines.empty());
  for (const ThickLine& line : lines) {
    for (size_t i = 0; i < line.points.size(); ++i) {
      EXPECT_EQ(Locate(line.points[i], region), Side::kInside) << ToText(line.points[i]);
    }
  }
}

TEST(MedialAxis, TurnsMirrorsAndShiftsWithTheRegion) {
  const PolygonWithHoles region = Region("(0 0, 6 0.3, 6 2, 5.5 2, 5.4 0.9, 0.4 0.6, 0.5 4, 0 4)");
  const double length = TotalLengthMm(MedialAxis(region, {}));
  const auto mapped = [&](auto map, bool mirrored) {
    PolygonWithHoles other = region;
    for (Point& p : other.outer) p = map(p);
    if (mirrored) std::reverse(other.outer.begin(), other.outer.end());
    return TotalLengthMm(MedialAxis(other, {}));
  };
  EXPECT_NEAR(mapped([](Point p) { return Point{-p.y, p.x}; }, false), length, 0.01);
  EXPECT_NEAR(mapped([](Point p) { return Point{-p.x, p.y}; }, true), length, 0.01);
  EXPECT_NEAR(mapped(
                  [](Point p) {
                    return p + Point{123'456'789, -98'765'432};
                  },
                  false),
              length, 0.01);
}

}  // namespace
}  // namespace slicefarm::beading::medial_axis_test
