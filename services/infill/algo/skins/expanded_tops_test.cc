#include "services/infill/algo/skins/expanded_tops.h"

#include <gtest/gtest.h>

#include <string_view>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::expanded_tops_test {
namespace {

/// A plane of 20 mm with a boss of 4 mm in its middle.
constexpr std::string_view kPlane = "(0 0, 20 0, 20 20, 0 20)";
constexpr std::string_view kBoss = "(8 8, 12 8, 12 12, 8 12)";

double GrowthOf(const SurfaceOptions& surfaces, std::string_view outline = kPlane,
                std::string_view above = kBoss) {
  return Area(TopGrowth(MakePolygonsOrDie(outline), MakePolygonsOrDie(above),
                        {.surfaces = surfaces, .walls_nm = 1'000'000, .width_nm = 400'000})) /
         1e12;
}

TEST(TopGrowth, FillsThePlaceUnderAFeature) {
  EXPECT_NEAR(GrowthOf({.expansion_nm = 1'000'000}), 16 - 4, 0.01);
  EXPECT_NEAR(GrowthOf({.expansion_nm = 5'000'000}), 16, 0.01);
  EXPECT_NEAR(GrowthOf({.expansion_nm = 0}), 0, 1e-9);
}

TEST(TopGrowth, GrowsAtTheEdgesOfItsDirection) {
  // A step: the left half is a top, and has a hole with a boss.
  constexpr std::string_view kStep = "(10 0, 20 0, 20 20, 10 20); (4 8, 6 8, 6 12, 4 12)";
  const auto grown = [&](ExpansionDirection direction) {
    return GrowthOf({.expansion_nm = 3'000'000, .expansion_direction = direction}, kPlane, kStep);
  };
  EXPECT_NEAR(grown(ExpansionDirection::kInward), 8, 0.01);
  EXPECT_NEAR(grown(ExpansionDirection::kOutward), 3 * 18, 0.01);
  EXPECT_NEAR(grown(ExpansionDirection::kBoth), 8 + 3 * 18, 0.01);
}

TEST(TopGrowth, KeepsTheMarginFromWalls) {
  constexpr std::string_view kStep = "(10 0, 20 0, 20 20, 10 20)";
  EXPECT_NEAR(
      GrowthOf({.expansion_nm = 3'000'000, .expansion_margin_nm = 2'000'000}, kPlane, kStep),
      3 * 14, 0.01);
}

TEST(TopGrowth, NeedsATopOfTwoLinesOnTheIsland) {
  EXPECT_EQ(GrowthOf({.expansion_nm = 5'000'000}, kPlane, "(1.5 0, 20 0, 20 20, 1.5 20)"), 0)
      << "0.5 mm inside the walls";
  constexpr std::string_view kTwo = "(0 0, 20 0, 20 20, 0 20); (21 0, 41 0, 41 20, 21 20)";
  EXPECT_NEAR(GrowthOf({.expansion_nm = 5'000'000}, kTwo, "(21 0, 41 0, 41 20, 21 20)"), 0, 1e-9)
      << "the other island has no top";
}

/// Returns squares of a number of sides, 12 mm apart.
MultiPolygon Squares(Coord in_row, Coord low_nm, Coord high_nm) {
  MultiPolygon squares;
  for (Coord i = 0; i < in_row * in_row; ++i) {
    const Point at{FromMm(12) * (i % in_row), FromMm(12) * (i / in_row)};
    const Point low{at.x + low_nm, at.y + low_nm}, high{at.x + high_nm, at.y + high_nm};
    squares.push_back({{low, {high.x, low.y}, high, {low.x, high.y}}, {}});
  }
  return squares;
}

// An operation with the whole layer above for each island would be quadratic.
TEST(TopGrowth, ManyIslandsAreFast) {
  constexpr Coord kInRow = 150;
  const MultiPolygon outline = Squares(kInRow, 0, FromMm(10));
  const MultiPolygon above = Squares(kInRow, FromMm(4), FromMm(6));
  const MultiPolygon growth = TopGrowth(
      outline, above,
      {.surfaces = {.expansion_nm = 5'000'000}, .walls_nm = 1'000'000, .width_nm = 400'000});
  EXPECT_EQ(growth.size(), outline.size());
  EXPECT_NEAR(Area(growth) / Area(above), 1, 1e-6);
}

}  // namespace
}  // namespace slicefarm::infill::expanded_tops_test
