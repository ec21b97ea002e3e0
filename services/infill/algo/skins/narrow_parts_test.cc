#include "services/infill/algo/skins/narrow_parts.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string_view>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::narrow_parts_test {
namespace {

double Mm2(const MultiPolygon& area) { return Area(area) / 1e12; }

TEST(PartByWidth, CutsLimbsOff) {
  // A square of 20 mm with a limb of 3 x 15 mm.
  const auto parts = PartByWidth(
      MakePolygonsOrDie("(0 0, 20 0, 20 5, 35 5, 35 8, 20 8, 20 20, 0 20)"), FromMm(4), 450'000);
  EXPECT_NEAR(Mm2(parts.wide), 400, 1e-3);
  EXPECT_NEAR(Mm2(parts.narrow), 45, 1e-3);
}

TEST(PartByWidth, KeepsCornersOfWideParts) {
  const MultiPolygon box = MakePolygonsOrDie("(0 0, 9 0, 9 7, 0 7)");
  const auto parts = PartByWidth(box, FromMm(4), 450'000);
  EXPECT_TRUE(parts.narrow.empty());
  EXPECT_EQ(parts.wide, box);
}

TEST(PartByWidth, ARingIsNarrowAllAround) {
  const auto parts = PartByWidth(
      MakePolygonsOrDie("(0 0, 30 0, 30 30, 0 30) (3 3, 3 27, 27 27, 27 3)"), FromMm(4), 450'000);
  EXPECT_TRUE(parts.wide.empty());
  EXPECT_NEAR(Mm2(parts.narrow), 900 - 576, 1e-3);
}

TEST(PartByWidth, LosesNothing) {
  const MultiPolygon solid =
      MakePolygonsOrDie("(0 0, 20 0, 30 1, 20 3, 20 20, 10 20, 9 30, 8 20, 0 20) (5 5, 5 8, 8 8)");
  const auto parts = PartByWidth(solid, FromMm(4), 450'000);
  ASSERT_FALSE(parts.narrow.empty());
  EXPECT_NEAR(Mm2(parts.wide) + Mm2(parts.narrow), Mm2(solid), 1e-3);
}

SolidParts ByLines(std::string_view solid, double angle_rad) {
  const auto parts = PartByLines(MakePolygonsOrDie(solid),
                                 {.angle_rad = angle_rad, .pitch_nm = 400'000}, FromMm(4));
  EXPECT_TRUE(parts.ok()) << parts.status();
  return *parts;
}

// A strip of 3 mm is narrow if its lines run across, not if they run along.
TEST(PartByLines, TheDirectionOfLinesDecides) {
  constexpr std::string_view kStrip = "(0 0, 20 0, 20 3, 0 3)";
  EXPECT_TRUE(ByLines(kStrip, 0).narrow.empty());
  const SolidParts across = ByLines(kStrip, std::numbers::pi / 2);
  EXPECT_NEAR(Mm2(across.narrow), 60, 0.5);
  EXPECT_LT(Mm2(across.wide), 0.5);
}

TEST(PartByLines, CutsLimbsOff) {
  const SolidParts parts =
      ByLines("(0 0, 20 0, 20 5, 35 5, 35 8, 20 8, 20 20, 0 20)", std::numbers::pi / 2);
  EXPECT_NEAR(Mm2(parts.narrow), 45, 1.5);
  EXPECT_NEAR(Mm2(parts.wide), 400, 1.5);
}

// One or two short lines beside long ones do not matter, as in a corner; alone they do.
TEST(PartByLines, FewShortLinesMatterOnlyAlone) {
  EXPECT_TRUE(ByLines("(0 0, 10 0, 10 9, 5.9 9, 5.9 10, 4.3 10, 4.3 9, 0 9)", 0).narrow.empty());
  EXPECT_FALSE(ByLines("(0 0, 3 0, 3 0.9, 0 0.9)", 0).narrow.empty());
}

/// Returns a comb with a back of 0.2 mm and `count` teeth of 0.02 x 0.02 mm, 0.02 mm apart.
MultiPolygon Comb(Coord count) {
  constexpr Coord kUnit = kNmPerMm / 50;
  const auto at = [&](Coord x, Coord y) { return Point{(x - count) * kUnit, y * kUnit}; };
  Polygon comb = {at(0, -10), at(2 * count - 1, -10)};
  for (Coord i = count; i-- > 0;) {
    comb.insert(comb.end(), {at(2 * i + 1, 1), at(2 * i, 1)});
    if (i > 0) comb.insert(comb.end(), {at(2 * i, 0), at(2 * i - 1, 0)});
  }
  return {{comb, {}}};
}

// Two lines meet all teeth: too few to be narrow. A search for neighbours along whole lines would
// need more than 10^10 steps.
TEST(PartByLines, CombsOfManyTeethAreFast) {
  const MultiPolygon comb = Comb(90'000);
  const auto parts = PartByLines(comb, {.phase_nm = 5'000, .pitch_nm = 10'000}, FromMm(0.1));
  ASSERT_TRUE(parts.ok()) << parts.status();
  EXPECT_EQ(parts->wide, comb);
  EXPECT_TRUE(parts->narrow.empty());
}

// Teeth of 2 x 16 mm, with lines across them at 45 degrees. One union of all strips would take
// minutes.
TEST(PartByLines, CombsOfManyNarrowTeethAreFast) {
  constexpr Coord kTeeth = 500, kTooth = 2 * kNmPerMm;
  MultiPolygon comb = Comb(kTeeth);
  for (Point& p : comb[0].outer) {
    const bool is_tip = p.y > 0;
    p = {p.x * 100, is_tip ? 8 * kTooth : p.y * 100};
  }
  const auto parts =
      PartByLines(comb, {.angle_rad = std::numbers::pi / 4, .pitch_nm = 400'000}, FromMm(4));
  ASSERT_TRUE(parts.ok()) << parts.status();
  EXPECT_NEAR(Mm2(parts->narrow), kTeeth * 32, 0.1 * kTeeth * 32);
  EXPECT_NEAR(Mm2(parts->wide) + Mm2(parts->narrow), Mm2(comb), 1);
}

}  // namespace
}  // namespace slicefarm::infill::narrow_parts_test
