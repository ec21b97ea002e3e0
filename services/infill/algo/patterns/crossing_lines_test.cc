#include "services/infill/algo/patterns/crossing_lines.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format.h"

namespace slicefarm::infill {
namespace {

MultiPolygon Box() { return MakePolygonsOrDie("(-24 -24, 24 -24, 24 24, -24 24)"); }

double LengthOf(const std::vector<Piece>& pieces) {
  double length = 0;
  for (const Piece& piece : pieces)
    length += piece.closed ? Perimeter(piece.points) : Length(piece.points);
  return length;
}

TEST(CrossingLines, FamiliesShareTheDensity) {
  const PatternPlace place{.pitch_nm = 2e6};
  // Whole periods of the grid; the others within a line at the corners.
  EXPECT_NEAR(LengthOf(*Grid(Box(), place)) * 2e6 / Area(Box()), 1, 1e-6);
  for (MakePattern* pattern : {Triangles, Stars, Cubic})
    EXPECT_NEAR(LengthOf(*pattern(Box(), place)) * 2e6 / Area(Box()), 1, 0.06);
}

// The planes of cubes: a line moves sideways by height / sqrt 2, and one pitch further lies where the
// next one was.
TEST(CrossingLines, CubicDriftsWithTheHeight) {
  const double pitch = 2e6;
  const auto low = Cubic(Box(), {.pitch_nm = pitch});
  const auto high = Cubic(Box(), {.z_nm = 1'000'000, .pitch_nm = pitch});
  const auto period = Cubic(Box(), {.z_nm = 8'485'281, .pitch_nm = pitch});  // 3 sqrt 2 pitches
  EXPECT_EQ((*high)[4].points[0].y - (*low)[4].points[0].y, 707'107);
  ASSERT_EQ(low->size(), period->size());
  EXPECT_NEAR(static_cast<double>((*period)[4].points[0].y - (*low)[4].points[0].y), 6e6, 1);
}

}  // namespace
}  // namespace slicefarm::infill
