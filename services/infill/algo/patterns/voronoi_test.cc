#include "services/infill/algo/patterns/voronoi.h"

#include <gtest/gtest.h>

#include "services/infill/algo/patterns/pattern_samples_test.h"

namespace slicefarm::infill::voronoi_test {
namespace {

constexpr PatternContext kPlace{.pitch_nm = 2e6, .angle_rad = 0.3, .spacing_nm = 400'000};

// The error is 0.2 % for whole tiles.
TEST(Voronoi, IsAsDenseAsAsked) {
  const MultiPolygon plate = MakePolygonsOrDie("(-250 -250, 250 -250, 250 250, -250 250)");
  for (const double pitch_nm : {1.5e6, 2e6, 4e6, 8e6}) {
    PatternContext context = kPlace;
    context.pitch_nm = pitch_nm;
    const auto pieces = Voronoi(plate, context);
    ASSERT_TRUE(pieces.ok());
    EXPECT_NEAR(LengthOf(*pieces) * pitch_nm / Area(plate), 1, pitch_nm < 4e6 ? 0.003 : 0.015)
        << pitch_nm;
  }
}

TEST(Voronoi, IsTheSameInAllLayers) {
  PatternContext above = kPlace;
  above.z_nm = 7'700'000;
  above.layer = 38;
  const auto low = Voronoi(SampleBox(), kPlace), high = Voronoi(SampleBox(), above);
  ASSERT_EQ(low->size(), high->size());
  for (size_t i = 0; i < low->size(); ++i) EXPECT_EQ((*low)[i].points, (*high)[i].points);
}

// Islands are in the same pattern: two halves have the total length of the whole.
TEST(Voronoi, IslandsAgree) {
  const MultiPolygon left = MakePolygonsOrDie("(-24 -24, 3 -24, 3 24, -24 24)");
  const MultiPolygon right = MakePolygonsOrDie("(3 -24, 24 -24, 24 24, 3 24)");
  EXPECT_NEAR(LengthOf(*Voronoi(left, kPlace)) + LengthOf(*Voronoi(right, kPlace)),
              LengthOf(*Voronoi(SampleBox(), kPlace)), 1'000);
}

// Lines follow the edges without a stop: all pieces end at the region's edge.
TEST(Voronoi, NoLineEndsInside) {
  const auto pieces = Voronoi(SampleBox(), kPlace);
  ASSERT_TRUE(pieces.ok());
  int open = 0;
  for (const Piece& piece : *pieces) {
    if (piece.closed) continue;
    ++open;
    EXPECT_GE(piece.from.ring, 0);
    EXPECT_GE(piece.to.ring, 0);
  }
  EXPECT_GT(open, 0);
}

}  // namespace
}  // namespace slicefarm::infill::voronoi_test
