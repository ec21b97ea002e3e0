#include "services/infill/algo/patterns/concentric.h"

#include <gtest/gtest.h>

#include "services/infill/algo/patterns/pattern_samples_test.h"

namespace slicefarm::infill::concentric_test {
namespace {

TEST(Concentric, LoopsAreAPitchApart) {
  const auto loops = Concentric(SampleBox(), {.pitch_nm = 2e6});
  ASSERT_EQ(loops->size(), 12u);
  EXPECT_NEAR(LengthOf(*loops) * 2e6 / Area(SampleBox()), 1, 1e-6);
  for (const Piece& loop : *loops) EXPECT_TRUE(loop.closed);
}

TEST(Concentric, HolesHaveLoopsOfTheirOwn) {
  const auto region =
      MakePolygonsOrDie("(-24 -24, 24 -24, 24 24, -24 24) (-5 -5, -5 5, 5 5, 5 -5)");
  EXPECT_EQ(Concentric(region, {.pitch_nm = 6e6})->size(), 4u);
}

}  // namespace
}  // namespace slicefarm::infill::concentric_test
