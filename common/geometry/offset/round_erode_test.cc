#include "common/geometry/offset/round_erode.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <string_view>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/clipper_oracle_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::round_erode_test {
namespace {

PolygonWithHoles Region(std::string_view text) { return MakePolygonsOrDie(text)[0]; }

/// Returns a ring with waves, counter-clockwise.
Polygon Waves(int points, double radius_mm, int waves, double depth) {
  Polygon ring;
  for (int i = 0; i < points; ++i) {
    const double t = 2 * std::numbers::pi * i / points;
    const double r = radius_mm * (1 + depth * std::sin(waves * t));
    ring.push_back({FromMm(r * std::cos(t)), FromMm(r * std::sin(t))});
  }
  return ring;
}

// For any shape and distance, the result is the same region as Clipper's with round joins.
TEST(RoundErode, EqualsClippers) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  int made = 0;
  for (int i = 0; i < 100; ++i) {
    Polygon ring = Waves(30 + static_cast<int>(100 * unit(random)), 5,
                         2 + static_cast<int>(9 * unit(random)), 0.6 * unit(random));
    const MultiPolygon region = Union(std::vector<Polygon>{std::move(ring)}, FillRule::kPositive);
    if (region.size() != 1) continue;
    for (const double mm : {0.2, 0.6, 1.3, 2.4}) {
      const auto got = TryRoundErode(region[0], FromMm(mm), 500);
      if (!got) continue;
      ++made;
      const MultiPolygon want =
          ClipperOffset(region, FromMm(-mm), {.join = Join::kRound, .arc_tolerance_nm = 500});
      double perimeter = 0;
      for (const Polygon& outline : Rings(want)) perimeter += Perimeter(outline) / kNmPerMm;
      EXPECT_LT(Apart(*got, want), 0.002 * (0.1 + perimeter)) << i << " " << mm;
    }
  }
  EXPECT_GT(made, 300);
}

struct WidthCase {
  std::string name;
  PolygonWithHoles region;
  Width width;
};
class JudgedWidth : public testing::TestWithParam<WidthCase> {};

// Discs with a radius of 1 mm; sides that meet at less than 10 degrees face each other.
TEST_P(JudgedWidth, IsThatOfTheIsland) {
  constexpr double kMostTurn = 170 * std::numbers::pi / 180;
  EXPECT_EQ(JudgeWidth(GetParam().region, FromMm(1), kMostTurn), GetParam().width);
}

std::vector<WidthCase> WidthCases() {
  const Polygon plate = Region("(-10 -10, 10 -10.1, 10.1 10, -10.2 10.3)").outer;
  const auto with_hole = [&](Polygon hole) {
    std::reverse(hole.begin(), hole.end());
    return PolygonWithHoles{plate, {std::move(hole)}};
  };
  return {
      {"Plate", {plate, {}}, Width::kWide},
      {"PlateWithHole", with_hole(Waves(60, 5, 1, 0)), Width::kWide},
      {"HoleNearTheOutline", with_hole(Waves(60, 8.5, 1, 0)), Width::kNarrow},
      // The corners are rounded with a radius below that of the discs.
      {"RoundedCorners",
       {Region("(0.5 0, 9.5 0.01, 9.85 .14, 10 0.5, 10 7.5, 9.86 7.85, 9.5 8, 0.5 8.01, .15 7.86, "
               "0.01 7.5, 0 0.5, .14 .16)")
            .outer,
        {}},
       Width::kWide},
      {"Tooth", Region("(0 0, 10 0.1, 10 6, 5.25 6.1, 5.2 7, 4.8 7.1, 4.77 6.1, 0 6.2)"),
       Width::kNarrow},
      {"Groove", Region("(0 0, 10 0.1, 10 6, 5.4 6.1, 5.2 3, 4.8 3.1, 4.6 6.1, 0 6.2)"),
       Width::kWide},
      {"GrooveTooDeep", Region("(0 0, 10 0.1, 10 6, 5.4 6.1, 5.2 1.7, 4.8 1.8, 4.6 6.1, 0 6.2)"),
       Width::kNarrow},
      {"TipOf22Degrees", Region("(0 0, 20 0.1, 0.1 8)"), Width::kWide},
      {"TipOf6Degrees", Region("(0 0, 60 0.1, 0.1 6.3)"), Width::kNarrow},
      {"Neck",
       Region("(0 0, 8 .1, 8.1 3, 12 3.2, 12 0, 20 .1, 20.1 8, 12 8.1, 12.1 4.9, 8 4.7, "
              "8.1 8, 0 8.2)"),
       Width::kNarrow},
      {"Strip", Region("(0 0, 20 0.1, 20.1 1.9, 0.1 1.8)"), Width::kNarrow},
  };
}

INSTANTIATE_TEST_SUITE_P(RoundErode, JudgedWidth, testing::ValuesIn(WidthCases()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace slicefarm::round_erode_test
