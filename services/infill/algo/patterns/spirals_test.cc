#include "services/infill/algo/patterns/spirals.h"

#include <gtest/gtest.h>

#include <numbers>

#include "services/infill/algo/patterns/pattern_samples_test.h"

namespace slicefarm::infill::spirals_test {
namespace {

TEST(Spirals, TurnsAreAPitchApart) {
  const double pitch = 2e6;
  EXPECT_NEAR(LengthOf(*Archimedean(SampleBox(), {.pitch_nm = pitch})) * pitch / Area(SampleBox()),
              1, 0.03);
  EXPECT_NEAR(LengthOf(*Octagram(SampleBox(), {.pitch_nm = pitch})) * pitch / Area(SampleBox()), 1,
              0.04);
}

// A spiral far from the origin is a part of the same spiral.
TEST(Spirals, AreTheSameInAllRegions) {
  const auto far = MakePolygonsOrDie("(100 0, 110 0, 110 10, 100 10)");
  const auto near = MakePolygonsOrDie("(-1 -1, 110 -1, 110 10, -1 10)");
  for (MakePattern* pattern : {Archimedean, Octagram}) {
    const auto part = pattern(far, {.pitch_nm = 2e6});
    const auto whole = pattern(near, {.pitch_nm = 2e6});
    ASSERT_FALSE(part->empty());
    for (const Piece& piece : *part) {
      if (piece.points.size() < 3) continue;
      const Point middle = piece.points[1];
      bool found = false;
      for (const Piece& other : *whole)
        for (const Point p : other.points) found |= Distance(p, middle) < 2;
      EXPECT_TRUE(found) << ToText(middle);
    }
  }
}

}  // namespace
}  // namespace slicefarm::infill::spirals_test
