#include "services/infill/algo/patterns/line_families.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace slicefarm::infill::line_families_test {
namespace {

TEST(LineFamilies, TogetherHaveThePitchThatIsAskedFor) {
  for (const FillPatternInfo& info : kFillPatterns) {
    double per_area = 0;
    for (const LineFamily& family : LineFamiliesOf(info.pattern, {.pitch_nm = 2e6}))
      per_area += 1 / family.pitch_nm;
    if (per_area > 0) {
      EXPECT_NEAR(per_area, 1 / 2e6, 1e-15) << info.name;
    }
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
