#include "common/geometry/offset/offset_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/clipper_oracle_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::internal::offset_curve_test {
namespace {

struct CurveCase {
  std::string name;
  std::string ring;
  double distance_mm;
  Join join;
  std::string want;
};
class Curve : public testing::TestWithParam<CurveCase> {};

TEST_P(Curve, Is) {
  const CurveCase& c = GetParam();
  const Polygon curve =
      OffsetCurve(MakeLineOrDie(c.ring), c.distance_mm * kNmPerMm, {.join = c.join});
  EXPECT_EQ(ToText(curve), ToText(MakeLineOrDie(c.want)));
}

INSTANTIATE_TEST_SUITE_P(
    OffsetCurve, Curve,
    testing::Values(  // name, ring, distance, join, curve
        CurveCase{"MitersWhereTheyOpen", "(0 0, 10 0, 10 10, 0 10)", 1, Join::kMiter,
                  "(-1 -1, 11 -1, 11 11, -1 11)"},
        CurveCase{
            "GoesByTheCornerWhereTheyClose", "(0 0, 10 0, 0 10)", -1, Join::kMiter,
            "(1 0, 0 0, 0 1, 10 1, 10 0, 9.292893 -0.707107, -0.707107 9.292893, 0 10, 1 10)"},
        CurveCase{"HolesShrinkWhenRegionsGrow", "(0 0, 0 10, 10 10, 10 0)", 1, Join::kMiter,
                  "(0 1, 0 0, 1 0, 1 10, 0 10, 0 9, 10 9, 10 10, 9 10, 9 0, 10 0, 10 1)"},
        CurveCase{"RepeatsAndStraightCornersDoNothing",
                  "(0 0, 0 0, 5 0, 10 0, 10 10, 10 10, 0 10, 0 0)", 1, Join::kMiter,
                  "(-1 -1, 5 -1, 11 -1, 11 11, -1 11)"},
        CurveCase{"SquareJoinsTouchTheArc", "(0 0, 10 0, 10 10, 0 10)", 1, Join::kSquare,
                  "(-1 -0.414214, -0.414214 -1, 10.414214 -1, 11 -0.414214, 11 10.414214, "
                  "10.414214 11, -0.414214 11, -1 10.414214)"}),
    [](const auto& info) { return info.param.name; });

TEST(OffsetCurve, RingsOfLessThanThreePointsAreNone) {
  for (const char* ring : {"(0 0, 1 1)", "(0 0, 1 1, 1 1, 0 0)"})
    EXPECT_TRUE(OffsetCurve(MakeLineOrDie(ring), 1e6, {}).empty()) << ring;
}

/// Returns a ring with teeth, waves and fine points, with a hole.
PolygonWithHoles Spiky(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  PolygonWithHoles island;
  const int points = 5 + static_cast<int>(100 * unit(random));
  const double noise = unit(random), waves = std::floor(7 * unit(random));
  Polygon hole;
  for (int i = 0; i < points; ++i) {
    const double t = 2 * std::numbers::pi * i / points;
    const double r = 6 * (1 + 0.3 * std::sin(waves * t) - 0.6 * noise * unit(random));
    island.outer.push_back({FromMm(r * std::cos(t)), FromMm(r * std::sin(t))});
    hole.push_back({FromMm(0.2 * r * std::cos(-t)), FromMm(0.3 * r * std::sin(-t))});
  }
  island.holes.push_back(hole);
  return island;
}

/// The area that only one of two regions covers, for each nanometre of an outline.
double ApartNm(const MultiPolygon& a, const MultiPolygon& b) {
  double length = 1;
  ForEachRing(a, [&](const Polygon& ring) { length += Perimeter(ring); });
  return (Area(Difference(a, b)) + Area(Difference(b, a))) / length;
}

// Corners lie where Clipper has them, to the rounding of crossings.
TEST(OffsetCurve, GivesWhatClipperOffsetGives) {
  std::mt19937 random(5);
  for (int i = 0; i < 100; ++i) {
    const MultiPolygon region = Union({Spiky(random)}, MultiPolygon());
    for (const Join join : {Join::kMiter, Join::kSquare, Join::kRound}) {
      for (const double mm : {-2.3, -0.4, -0.01, 0.05, 0.7}) {
        const OffsetOptions options = {.join = join, .miter_limit = i % 2 == 0 ? 2.0 : 4.0};
        const MultiPolygon offset = Offset(region, FromMm(mm), options);
        const MultiPolygon expected = ClipperOffset(region, FromMm(mm), options);
        EXPECT_LT(ApartNm(offset, expected), 1) << i << " " << mm;
        EXPECT_EQ(offset.empty(), expected.empty()) << i << " " << mm;
      }
    }
  }
}

}  // namespace
}  // namespace slicefarm::internal::offset_curve_test
