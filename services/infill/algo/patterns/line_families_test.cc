#include "services/infill/algo/patterns/line_families.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slicefarm::infill::line_families_test {
namespace {

TEST(LineFamilies, TogetherHaveThePitchThatIsAskedFor) {
  for (const FillPatternInfo& info : kFillPatterns) {
    // Heights are spread over a period of lateral honeycombs, which have more lines at some
    // heights.
    constexpr int kHeights = 30;
    double per_area = 0;
    for (int i = 0; i < kHeights; ++i) {
      const double thirds = 3.0 * (i + 0.5) / kHeights;
      PatternContext context{.z_nm = std::llround(thirds * 4e6 / 3), .pitch_nm = 2e6};
      context.shape.honeycomb_rad = std::numbers::pi / 4;
      for (const LineFamily& family : LineFamiliesOf(info.pattern, context))
        per_area += 1 / family.pitch_nm / kHeights;
    }
    if (per_area > 0) {
      EXPECT_NEAR(per_area, 1 / 2e6, 1e-15) << info.name;
    }
  }
}

TEST(LineFamilies, CrossZagShiftsEvenAndOddLayersApart) {
  const auto shift = [](int32_t layer) {
    return LineFamiliesOf(FillPattern::kCrossZag, {.layer = layer, .pitch_nm = 2e6})[0].phase_nm;
  };
  EXPECT_EQ(shift(0), 0);
  EXPECT_EQ(shift(1), 0);
  EXPECT_EQ(shift(6), -3 * 400'000);
  EXPECT_EQ(shift(7), 3 * 400'000);
}

TEST(LineFamilies, MirroredLinesHaveTheOppositeAngle) {
  PatternContext context{.layer = 4, .pitch_nm = 2e6, .angle_rad = 0.6};
  for (const FillPattern pattern : {FillPattern::kZigzag, FillPattern::kCrossZag}) {
    context.shape.mirrored = false;
    const LineFamily plain = LineFamiliesOf(pattern, context)[0];
    context.shape.mirrored = true;
    const LineFamily mirrored = LineFamiliesOf(pattern, context)[0];
    EXPECT_EQ(mirrored.angle_rad, -plain.angle_rad);
    EXPECT_EQ(mirrored.phase_nm, plain.phase_nm);
  }
}

/// Returns the distance between the two families of a pattern at a height, modulo the pitch of a
/// family, or -1 for a single family.
double Between(FillPattern pattern, const PatternContext& context) {
  const auto families = LineFamiliesOf(pattern, context);
  if (families.size() < 2) return -1;
  const double turns = (families[1].phase_nm - families[0].phase_nm) / families[0].pitch_nm;
  return (turns - std::floor(turns)) * families[0].pitch_nm;
}

// With 45 degrees to each side, the families move apart by twice the height. They never come nearer
// than a spacing.
TEST(LineFamilies, LatticeMovesWithTheHeight) {
  const auto at = [](double z_mm) {
    return Between(FillPattern::kLateralLattice,
                   {.z_nm = FromMm(z_mm), .pitch_nm = 2e6, .spacing_nm = 400'000});
  };
  EXPECT_NEAR(at(0), 4e5, 1);
  EXPECT_NEAR(at(0.5), 1e6, 1);
  EXPECT_NEAR(at(1), 2e6, 1);
  EXPECT_NEAR(at(1.95), 3.6e6, 1);
}

// Pitch 2 mm: walls of a row are 2.667 mm apart, half of that is the width of a fork. At 45
// degrees, a fork is as high as it is wide.
TEST(LineFamilies, LateralHoneycombForksInEveryThirdPartOfTheHeight) {
  PatternContext context{.pitch_nm = 2e6, .spacing_nm = 400'000};
  context.shape.honeycomb_rad = std::numbers::pi / 4;
  const double third_mm = 4.0 / 3;
  const auto at = [&](double thirds) {
    context.z_nm = FromMm(thirds * third_mm);
    return Between(FillPattern::kLateralHoneycomb, context);
  };
  for (const double upright : {0.1, 1.0, 1.9, 3.1, 4.9}) EXPECT_EQ(at(upright), -1) << upright;
  EXPECT_NEAR(at(2.5), 2e6 * 2 / 3, 10);
  EXPECT_NEAR(at(5.5), 2e6 * 2 / 3, 10);
  // Rows above a fork are half a period further.
  context.z_nm = 0;
  const double low = LineFamiliesOf(FillPattern::kLateralHoneycomb, context)[0].phase_nm;
  context.z_nm = FromMm(3.5 * third_mm);
  const double high = LineFamiliesOf(FillPattern::kLateralHoneycomb, context)[0].phase_nm;
  EXPECT_NEAR(high - low, 2e6 * 2 / 3, 1);
}

TEST(LineFamilies, SeveralLinesAreASpacingApart) {
  PatternContext context{.pitch_nm = 2e6, .spacing_nm = 400'000};
  context.shape.lines = 3;
  const auto families = LineFamiliesOf(FillPattern::kZigzag, context);
  ASSERT_EQ(families.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(families[static_cast<size_t>(i)].pitch_nm, 6e6);
    EXPECT_EQ(families[static_cast<size_t>(i)].phase_nm, (i - 1) * 400'000);
  }
}

TEST(LineFamilies, AreNoneForCurves) {
  for (const FillPattern pattern : {FillPattern::kGyroid, FillPattern::kHoneycomb,
                                    FillPattern::kConcentric, FillPattern::kHilbert})
    EXPECT_TRUE(LineFamiliesOf(pattern, {.pitch_nm = 1e6}).empty());
}

TEST(LineFamilies, RectilinearTurnsFromLayerToLayer) {
  const auto angle = [](FillPattern pattern, int32_t layer) {
    return LineFamiliesOf(pattern, {.layer = layer, .pitch_nm = 1e6})[0].angle_rad;
  };
  EXPECT_EQ(angle(FillPattern::kRectilinear, 0), 0);
  EXPECT_NEAR(angle(FillPattern::kRectilinear, 3), 1.5707963, 1e-6);
  EXPECT_EQ(angle(FillPattern::kZigzag, 3), 0);
}

}  // namespace
}  // namespace slicefarm::infill::line_families_test
