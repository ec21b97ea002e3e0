#include "services/beading/algo/arachne/constant_width_walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <string_view>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "services/beading/algo/strategy/strategy_factory.h"

namespace slicefarm::beading::constant_width_walls_test {
namespace {

constexpr int kWalls = 3;
constexpr double kErrorNm = 2'000;

PolygonWithHoles Region(std::string_view text) { return MakePolygonsOrDie(text)[0]; }

std::unique_ptr<const BeadingStrategy> Strategy() {
  StrategyOptions options;
  options.max_walls = kWalls;
  return MakeStrategy(options);
}

std::optional<VariableWalls> TryWide(const PolygonWithHoles& region) {
  VariableWallOptions options;
  options.tolerance_nm = options.chord_tolerance_nm = 100;
  return TryWideWalls(region, *Strategy(), kWalls, options);
}

std::optional<VariableWalls> Variable(const PolygonWithHoles& region) {
  VariableWallOptions options;
  options.tolerance_nm = options.chord_tolerance_nm = 100;
  return MakeVariableWalls(region, *Strategy(), options);
}

// Tests of arcs.

struct RoundingCase {
  std::string name;
  Polygon ring;
  int arcs;
};
class RoundedRing : public testing::TestWithParam<RoundingCase> {};

Polygon Reversed(Polygon ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

Polygon Circle(int corners, double radius_mm) {
  Polygon ring;
  for (int i = 0; i < corners; ++i) {
    const double turn = 2 * std::numbers::pi * i / corners;
    ring.push_back({FromMm(radius_mm * std::cos(turn)), FromMm(radius_mm * std::sin(turn))});
  }
  return ring;
}

// Around a reflex corner of 90 degrees, the inset by 0.4 mm loses the difference between a square
// and its quarter of a disc.
TEST_P(RoundedRing, LosesTheCornersOfItsArcs) {
  const RoundingCase& rounding = GetParam();
  constexpr Coord kDistance = 400'000, kTolerance = 100;
  const auto rounded = RoundReflexCorners(rounding.ring, kDistance, kTolerance);
  ASSERT_TRUE(rounded.has_value());
  const double corner = (1 - std::numbers::pi / 4) * kDistance * kDistance;
  EXPECT_NEAR(SignedArea(*rounded) - SignedArea(rounding.ring), rounding.arcs * corner,
              0.01 * corner);
  if (rounding.arcs == 0) {
    EXPECT_EQ(*rounded, rounding.ring);
  } else {
    EXPECT_GT(rounded->size(), rounding.ring.size() + 10 * static_cast<size_t>(rounding.arcs));
  }
}

INSTANTIATE_TEST_SUITE_P(
    WideWalls, RoundedRing,
    testing::Values(RoundingCase{"ConvexRing", Region("(0 0, 4 0, 4 4, 0 4)").outer, 0},
                    RoundingCase{"L", Region("(0 0, 4 0, 4 2, 2 2, 2 4, 0 4)").outer, 1},
                    RoundingCase{"U", Region("(0 0, 6 0, 6 4, 4 4, 4 2, 2 2, 2 4, 0 4)").outer, 2},
                    RoundingCase{"HoleWithArcsThatMeet",
                                 Reversed(Region("(0 0, .8 0, .8 2, 0 2)").outer), 4},
                    RoundingCase{"HoleOfSlightTurns", Reversed(Circle(128, 8)), 0}),
    [](const auto& info) { return info.param.name; });

struct UnroundedCase {
  std::string name;
  Polygon ring;
};
class UnroundedRing : public testing::TestWithParam<UnroundedCase> {};

TEST_P(UnroundedRing, IsLeftToOthers) {
  EXPECT_FALSE(RoundReflexCorners(GetParam().ring, 400'000, 1'000).has_value());
}

INSTANTIATE_TEST_SUITE_P(
    WideWalls, UnroundedRing,
    testing::Values(
        UnroundedCase{"NoRoomBetweenTwoArcs", Reversed(Region("(0 0, 0.79 0, 0.79 2, 0 2)").outer)},
        UnroundedCase{"TurnOf127Degrees", Region("(0 0, 4 0, 4 4, 2 0.5, 1 2.5, 0 4)").outer}),
    [](const auto& info) { return info.param.name; });

TEST(WideWalls, ArcsAreWithinTheTolerance) {
  constexpr Coord kDistance = 1'000'000;
  const Polygon ring = Region("(0 0, 6 0, 6 3, 3 3, 3 6, 0 6)").outer;
  size_t before = 1'000;
  for (const Coord tolerance : {100, 1'000, 10'000}) {
    const auto rounded = RoundReflexCorners(ring, kDistance, tolerance);
    ASSERT_TRUE(rounded.has_value());
    // The reflex corner belongs to an outline 1 mm from the ring, on the ring's right.
    const Point centre = {FromMm(4), FromMm(4)};
    double least = 1e18;
    for (size_t i = 0; i < rounded->size(); ++i) {
      const Point a = (*rounded)[i], b = (*rounded)[(i + 1) % rounded->size()];
      const double nearest = DistanceToSegment(centre, a, b);
      EXPECT_GE(Distance(centre, a), kDistance - 1.0);
      EXPECT_GE(nearest, kDistance - static_cast<double>(tolerance) - 1);
      least = std::min(least, nearest);
    }
    EXPECT_LT(least, kDistance - static_cast<double>(tolerance) / 4);
    EXPECT_LT(rounded->size(), before);
    before = rounded->size();
  }
}

// Tests of walls.

struct NarrowCase {
  std::string name;
  std::string text;
};
class NarrowIsland : public testing::TestWithParam<NarrowCase> {};

TEST_P(NarrowIsland, IsLeftToOthers) {
  const PolygonWithHoles region = Region(GetParam().text);
  EXPECT_FALSE(TryWide(region).has_value());
  EXPECT_TRUE(Variable(region).has_value());
}

// Three walls on both sides and something between them need 2.79 mm.
INSTANTIATE_TEST_SUITE_P(
    WideWalls, NarrowIsland,
    testing::Values(
        NarrowCase{"Strip", "(0 0, 20 0, 20 1, 0 1)"},
        NarrowCase{"StripAlmostWideEnough", "(0 0, 20 0, 20 2.78, 0 2.78)"},
        NarrowCase{"NeckBetweenWideParts",
                   "(0 0, 8 0, 8 3, 12 3, 12 0, 20 0, 20 8, 12 8, 12 5, 8 5, 8 8, 0 8)"},
        NarrowCase{"HoleNearTheOutline", "(0 0, 20 0, 20 20, 0 20) (2 8, 12 8, 12 12, 2 12)"},
        NarrowCase{"ToothOnAPlate", "(0 0, 20 0, 20 10, 11 10, 11 12, 9 12, 9 10, 0 10)"},
        NarrowCase{"TipOf6Degrees", "(0 0, 60 0, 0 6.3)"},
        // A square with a side of 3.3 mm leaves 0.5 mm2 to the infill.
        NarrowCase{"LittleFill", "(0 0, 3 0, 3 3, 0 3)"}),
    [](const auto& info) { return info.param.name; });

struct WideCase {
  std::string name;
  PolygonWithHoles region;
};

/// Returns a square with rounded corners of many edges. In insets beyond the corners' radius, these
/// edges vanish.
PolygonWithHoles RoundedPlate(double side_mm, int edges, double radius_mm) {
  Polygon ring;
  const double centre = side_mm / 2 - radius_mm;
  for (int corner = 0; corner < 4; ++corner) {
    for (int i = 0; i <= edges; ++i) {
      const double turn = std::numbers::pi / 2 * (corner + static_cast<double>(i) / edges);
      const int quarter = corner;
      const double x = quarter == 0 || quarter == 3 ? centre : -centre;
      const double y = quarter < 2 ? centre : -centre;
      ring.push_back(
          {FromMm(x + radius_mm * std::cos(turn)), FromMm(y + radius_mm * std::sin(turn))});
    }
  }
  return {ring, {}};
}

/// Returns a plate with a saw edge. Its teeth are lower than an outer wall is wide.
Polygon SmallTeeth() {
  Polygon ring = {{0, 0}, {FromMm(20), 0}};
  for (int i = 20; i >= 0; --i) {
    ring.push_back({FromMm(i), FromMm(10)});
    if (i > 0) ring.push_back({FromMm(i - 0.37), FromMm(10.15)});
  }
  return ring;
}

std::vector<WideCase> WideCases() {
  const Polygon plate = Region("(-10 -10, 10 -10, 10 10, -10 10)").outer;
  return {
      {"Square", {plate, {}}},
      {"StripJustWideEnough", Region("(0 0, 20 0, 20 2.9, 0 2.9)")},
      {"PlateWithRoundHole", {plate, {Reversed(Circle(64, 4))}}},
      {"PlateWithCoarseHole", {plate, {Reversed(Circle(7, 4))}}},
      {"PlateWithSquareHole", Region("(0 0, 20 0, 20 20, 0 20) (7 7, 13 7, 13 13, 7 13)")},
      {"L", Region("(0 0, 20 0, 20 6, 6 6, 6 20, 0 20)")},
      {"Disc", {Circle(200, 8), {}}},
      {"TipOf22Degrees", Region("(0 0, 20 0, 0 8)")},
      {"RoundedPlate", RoundedPlate(20, 16, 1)},
      {"PlateRoundedMore", RoundedPlate(10, 16, 0.45)},
      {"PlateWithSmallTeeth", {SmallTeeth(), {}}},
      {"PlateWithGroove", Region("(0 0, 20 0, 20 10, 11 10, 10.5 6, 9.5 6, 9 10, 0 10)")},
  };
}

class WideIsland : public testing::TestWithParam<WideCase> {
 protected:
  void SetUp() override {
    const auto wide = TryWide(GetParam().region), variable = Variable(GetParam().region);
    ASSERT_TRUE(wide.has_value());
    ASSERT_TRUE(variable.has_value());
    wide_ = *wide;
    variable_ = *variable;
  }

  VariableWalls wide_, variable_;
};

std::vector<ThickLine> OfInset(const VariableWalls& walls, int inset) {
  std::vector<ThickLine> lines;
  for (const WallLine& line : walls.lines)
    if (line.inset == inset) lines.push_back(line.line);
  return lines;
}

double DistanceTo(const std::vector<ThickLine>& lines, Point p) {
  double distance = std::numeric_limits<double>::infinity();
  for (const ThickLine& line : lines)
    for (size_t i = 0; i < line.points.size(); ++i)
      distance = std::min(distance, DistanceToSegment(p, line.points[i],
                                                      line.points[(i + 1) % line.points.size()]));
  return distance;
}

/// Returns the largest distance of points along the lines `from` to `lines`.
double FarthestFrom(const std::vector<ThickLine>& lines, const std::vector<ThickLine>& from) {
  double farthest = 0;
  for (const ThickLine& line : from) {
    for (size_t i = 0; i < line.points.size(); ++i) {
      const Point a = line.points[i], b = line.points[(i + 1) % line.points.size()];
      for (int k = 0; k < 16; ++k) {
        const Point p = {a.x + (b.x - a.x) * k / 16, a.y + (b.y - a.y) * k / 16};
        farthest = std::max(farthest, DistanceTo(lines, p));
      }
    }
  }
  return farthest;
}

TEST_P(WideIsland, BeadsAreWhereVariableOnesAre) {
  for (int inset = 0; inset < kWalls; ++inset) {
    SCOPED_TRACE(inset);
    const auto wide = OfInset(wide_, inset), variable = OfInset(variable_, inset);
    EXPECT_EQ(wide.size(), 1 + GetParam().region.holes.size());
    EXPECT_EQ(wide.size(), variable.size());
    EXPECT_LE(FarthestFrom(wide, variable), kErrorNm);
    EXPECT_LE(FarthestFrom(variable, wide), kErrorNm);
  }
  EXPECT_EQ(wide_.lines.size(), variable_.lines.size());
}

TEST_P(WideIsland, BeadsAreClosedAndOfTheOptimalWidth) {
  for (const VariableWalls* walls : {&wide_, &variable_}) {
    ASSERT_FALSE(walls->lines.empty());
    for (const WallLine& wall : walls->lines) {
      EXPECT_FALSE(wall.is_middle);
      EXPECT_TRUE(wall.line.closed);
      EXPECT_EQ(wall.line.thickness_nm.size(), wall.line.points.size());
      for (const Coord width : wall.line.thickness_nm) EXPECT_EQ(width, 400'000);
    }
  }
}

TEST_P(WideIsland, FillAreaIsTheSame) {
  double perimeter = 0;
  ForEachRing(variable_.fill_area, [&](const Polygon& ring) { perimeter += Perimeter(ring); });
  EXPECT_GT(perimeter, 0);
  EXPECT_LE(Area(Difference(wide_.fill_area, variable_.fill_area)), kErrorNm * perimeter);
  EXPECT_LE(Area(Difference(variable_.fill_area, wide_.fill_area)), kErrorNm * perimeter);
}

INSTANTIATE_TEST_SUITE_P(WideWalls, WideIsland, testing::ValuesIn(WideCases()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace slicefarm::beading::constant_width_walls_test
