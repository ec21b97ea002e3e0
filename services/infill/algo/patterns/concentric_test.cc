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

// Two lines side by side, then the space of two pitches less the group's width.
TEST(Concentric, GroupsAreTwoPitchesApart) {
  PatternContext context{.pitch_nm = 2e6, .spacing_nm = 400'000};
  context.shape.lines = 2;
  const auto loops = Concentric(SampleBox(), context);
  ASSERT_EQ(loops->size(), 12u);
  EXPECT_NEAR(LengthOf(*loops) * 2e6 / Area(SampleBox()), 1, 1e-6);
  const auto side = [&](size_t i) { return Bounds((*loops)[i].points).max.x; };
  EXPECT_EQ(side(0) - side(1), 400'000);
  EXPECT_EQ(side(1) - side(2), 3'600'000);
  EXPECT_EQ(side(2) - side(3), 400'000);
}

TEST(Concentric, HolesHaveLoopsOfTheirOwn) {
  const auto region =
      MakePolygonsOrDie("(-24 -24, 24 -24, 24 24, -24 24) (-5 -5, -5 5, 5 5, 5 -5)");
  EXPECT_EQ(Concentric(region, {.pitch_nm = 6e6})->size(), 4u);
}

}  // namespace
}  // namespace slicefarm::infill::concentric_test
