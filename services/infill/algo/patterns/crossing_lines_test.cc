#include "services/infill/algo/patterns/crossing_lines.h"

#include <gtest/gtest.h>

#include "services/infill/algo/patterns/pattern_samples_test.h"

namespace slicefarm::infill::crossing_lines_test {
namespace {

TEST(CrossingLines, FamiliesShareTheDensity) {
  const PatternContext context{.pitch_nm = 2e6};
  // The grid has whole periods. The result of the other patterns is exact except for about a line
  // at the corners.
  EXPECT_NEAR(LengthOf(*Grid(SampleBox(), context)) * 2e6 / Area(SampleBox()), 1, 1e-6);
  for (MakePattern* pattern : {Triangles, Stars, Cubic})
    EXPECT_NEAR(LengthOf(*pattern(SampleBox(), context)) * 2e6 / Area(SampleBox()), 1, 0.06);
}

// In the planes of cubes a line shifts sideways by height / sqrt 2. After one pitch it is at the
// position of the next line.
TEST(CrossingLines, CubicDriftsWithTheHeight) {
  const double pitch = 2e6;
  const auto low = Cubic(SampleBox(), {.pitch_nm = pitch});
  const auto high = Cubic(SampleBox(), {.z_nm = 1'000'000, .pitch_nm = pitch});
  const auto period =
      Cubic(SampleBox(), {.z_nm = 8'485'281, .pitch_nm = pitch});  // 3 sqrt 2 pitches
  EXPECT_EQ((*high)[4].points[0].y - (*low)[4].points[0].y, 707'107);
  ASSERT_EQ(low->size(), period->size());
  EXPECT_NEAR(static_cast<double>((*period)[4].points[0].y - (*low)[4].points[0].y), 6e6, 1);
}

}  // namespace
}  // namespace slicefarm::infill::crossing_lines_test
