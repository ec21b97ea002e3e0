#include "common/geometry/offset/grown_area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string_view>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/clipper_oracle_test.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::grown_area_test {
namespace {

double LeastMm2(std::string_view text, double mm) {
  return LeastGrownArea(MakePolygonsOrDie(text)[0], FromMm(mm)) / 1e12;
}

double ClipperMm2(const MultiPolygon& region, double mm) {
  return Area(ClipperOffset(region, FromMm(mm), {.join = Join::kRound, .arc_tolerance_nm = 100})) /
         1e12;
}

TEST(GrownArea, HasASectorAtEachCorner) {
  const double square = 16 + 16 + std::numbers::pi;
  EXPECT_NEAR(LeastMm2("(0 0, 4 0, 4 4, 0 4)", 1), square, 0.01);
  EXPECT_LE(LeastMm2("(0 0, 4 0, 4 4, 0 4)", 1), square);
}

TEST(GrownArea, CountsTheOverlapOfAReflexCornerOnce) {
  // The rectangles at the reflex corner overlap in a square of 1 mm2.
  EXPECT_NEAR(LeastMm2("(0 0, 8 0, 8 4, 4 4, 4 8, 0 8)", 1), 48 + 32 + 5 * std::numbers::pi / 4 - 1,
              0.02);
}

TEST(GrownArea, HolesShrink) {
  EXPECT_NEAR(LeastMm2("(0 0, 10 0, 10 10, 0 10) (3 3, 3 7, 7 7, 7 3)", 1),
              100 + 40 + std::numbers::pi - 4, 0.02);
}

// The regions are eroded first, so that they do not overlap themselves when they grow again.
TEST(GrownArea, IsNearlyThatOfAnErosionGrownAgain) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  int cases = 0;
  for (int i = 0; i < 200; ++i) {
    Polygon ring;
    const int points = 20 + static_cast<int>(100 * unit(random)), waves = 2 + i % 5;
    const double depth = 0.3 * unit(random);
    for (int k = 0; k < points; ++k) {
      const double t = 2 * std::numbers::pi * k / points;
      const double r = 5 * (1 + depth * std::sin(waves * t) + 0.02 * unit(random));
      ring.push_back({FromMm(r * std::cos(t)), FromMm(r * std::sin(t))});
    }
    const MultiPolygon core =
        ClipperOffset({{ring, {}}}, FromMm(-0.4), {.join = Join::kRound, .arc_tolerance_nm = 100});
    if (core.size() != 1 || !core[0].holes.empty()) continue;
    ++cases;
    const double least = LeastGrownArea(core[0], FromMm(0.4)) / 1e12;
    const double grown = ClipperMm2(core, 0.4);
    EXPECT_LE(least, grown + 0.001) << i;
    EXPECT_NEAR(least, grown, 0.05) << i;
  }
  EXPECT_GT(cases, 50);
}

}  // namespace
}  // namespace slicefarm::grown_area_test
