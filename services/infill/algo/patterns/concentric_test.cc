#include "services/infill/algo/patterns/concentric.h"

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

TEST(Concentric, LoopsAreAPitchApart) {
  const auto loops = Concentric(Box(), {.pitch_nm = 2e6});
  ASSERT_EQ(loops->size(), 12u);
  EXPECT_NEAR(LengthOf(*loops) * 2e6 / Area(Box()), 1, 1e-6);
  for (const Piece& loop : *loops) EXPECT_TRUE(loop.closed);
}

TEST(Concentric, HolesHaveLoopsOfTheirOwn) {
  const auto region =
      MakePolygonsOrDie("(-24 -24, 24 -24, 24 24, -24 24) (-5 -5, -5 5, 5 5, 5 -5)");
  EXPECT_EQ(Concentric(region, {.pitch_nm = 6e6})->size(), 4u);
}

}  // namespace
}  // namespace slicefarm::infill
