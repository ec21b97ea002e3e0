#include "services/infill/algo/fields/field_pieces.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "services/infill/algo/fields/field_samples_test.h"
#include "services/infill/algo/fields/streamlines.h"
#include "services/infill/algo/inside_checks_test.h"
#include "services/infill/algo/quality/fill_plastic.h"
#include "services/infill/algo/sparse.h"

namespace slicefarm::infill::field_pieces_test {
namespace {

MultiPolygon Square(double side) {
  const Coord s = FromMm(side);
  return {{{{0, 0}, {s, 0}, {s, s}, {0, s}}, {}}};
}

double LengthMm(const Piece& piece) {
  double length = 0;
  for (size_t i = 1; i < piece.points.size(); ++i)
    length += ToMm(Distance(piece.points[i - 1], piece.points[i]));
  return length;
}

TEST(PiecesOfField, EveryPatternGivesTheMeanDensity) {
  const DensityField density =
      GridField(3, 64, [](double x, double) { return 0.1 + 0.3 * x / 64; });
  for (const FillPatternInfo& info : kFillPatterns) {
    if (!info.sparse || !info.has_law) continue;
    double plastic_mm3 = 0;
    constexpr int kLayers = 40;
    for (int layer = 0; layer < kLayers; ++layer) {
      const LayerField field{.density = &density, .z_mm = 0.2 * layer + 0.1};
      const auto paths = FillSparse(Square(64), {.pattern = info.pattern,
                                                 .angle_rad = 0.785,
                                                 .layer = layer,
                                                 .z_nm = 200'000 * layer + 100'000,
                                                 .anchor_nm = 2'000'000,
                                                 .anchor_max_nm = 20'000'000,
                                                 .field = &field});
      ASSERT_TRUE(paths.ok()) << info.name;
      for (const Path& path : *paths) plastic_mm3 += PlasticMm3(path, 200'000);
    }
    const double volume_mm3 = 64.0 * 64 * 0.2 * kLayers;
    // Links along the walls add plastic, on half of the perimeter.
    const double links = 0.5 * 4 * 64 * 0.407 / (64 * 64 * 0.25);
    EXPECT_GE(plastic_mm3 / volume_mm3 / 0.25, 0.975) << info.name;
    EXPECT_LE(plastic_mm3 / volume_mm3 / 0.25, 1.025 + links) << info.name;
  }
}

TEST(PartsOfField, DitherWhereTheFieldSaysSo) {
  DensityField density = GridField(3, 64, [](double x, double) { return 0.5 * x / 64; });
  const LayerField field{.density = &density};
  EXPECT_FALSE(IsInParts(FillPattern::kGrid, field));
  EXPECT_TRUE(IsInParts(FillPattern::kGyroid, field));
  density.dither = Dither::kFloydSteinberg;
  EXPECT_TRUE(IsInParts(FillPattern::kGrid, field));
  const auto parts = PartsOfField(Square(64), field);
  ASSERT_TRUE(parts.ok());
  ASSERT_EQ(parts->size(), 1u);
  EXPECT_EQ(parts->front().density, 0.5);
  EXPECT_NEAR(Area(parts->front().area) / Area(Square(64)), 0.5, 0.01);
}

TEST(PiecesOfField, StreamlinesStandInForThePattern) {
  StressField stress;
  stress.xx.values = {1};
  const DirectionField directions(stress);
  const LayerField field{.directions = &directions, .plain_density = 0.2};
  const auto filled =
      PiecesOfField(Square(60), FillPattern::kGyroid, {.spacing_nm = 400'000}, field);
  ASSERT_TRUE(filled.ok());
  double length = 0;
  for (const Piece& piece : *filled) {
    EXPECT_NEAR(piece.points[0].y, piece.points[1].y, 2);
    length += LengthMm(piece);
  }
  EXPECT_NEAR(length * 0.4 / 3600, 0.2, 0.01);
}

TEST(PiecesOfField, RememberedStreamlinesAreThoseOfTheirBoxAndSpacing) {
  StressField stress;
  stress.xx.values = {1};
  const DirectionField directions(stress);
  const LayerField plain{.directions = &directions, .plain_density = 0.2};
  StreamMemo memo;
  LayerField remembers = plain;
  remembers.memo = &memo;
  for (const Coord spacing : {400'000, 400'000, 500'000}) {
    for (const double side : {20.0, 20.5, 60.0, 20.0}) {
      const PatternContext place{.spacing_nm = spacing};
      const auto fresh = PiecesOfField(Square(side), FillPattern::kGrid, place, plain);
      const auto again = PiecesOfField(Square(side), FillPattern::kGrid, place, remembers);
      ASSERT_TRUE(fresh.ok() && again.ok());
      ASSERT_EQ(fresh->size(), again->size());
      for (size_t i = 0; i < fresh->size(); ++i)
        EXPECT_EQ((*fresh)[i].points, (*again)[i].points) << side << ", " << spacing;
    }
  }
}

TEST(PiecesOfField, PathsLieInsideAndKeepTheDensity) {
  const DensityField density =
      GridField(31, 60, [](double x, double y) { return 0.1 + 0.2 * (x + y) / 60; });
  const LayerField field{.density = &density};
  const MultiPolygon region = Square(60);
  for (const FillPattern pattern :
       {FillPattern::kRectilinear, FillPattern::kGrid, FillPattern::kCubic, FillPattern::kGyroid}) {
    const auto paths = FillSparse(
        region,
        {.pattern = pattern, .anchor_nm = 2'000'000, .anchor_max_nm = 20'000'000, .field = &field});
    ASSERT_TRUE(paths.ok());
    ASSERT_FALSE(paths->empty());
    ExpectInside(*paths, region);
  }
}

}  // namespace
}  // namespace slicefarm::infill::field_pieces_test
