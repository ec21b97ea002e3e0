#include "services/infill/algo/fields/field_pieces.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format.h"
#include "services/infill/algo/fields/field_samples_test.h"
#include "services/infill/algo/inside_checks_test.h"
#include "services/infill/algo/patterns/line_families.h"
#include "services/infill/algo/sparse.h"

namespace slicefarm::infill {
namespace {

MultiPolygon Square(double side) {
  const Coord s = FromMm(side);
  return {{{{0, 0}, {s, 0}, {s, s}, {0, s}}, {}}};
}

double LengthMm(const FieldPieces& filled) {
  double length = 0;
  for (const Piece& piece : filled.pieces) {
    for (size_t i = 1; i < piece.points.size(); ++i)
      length += ToMm(Distance(piece.points[i - 1], piece.points[i]));
    if (piece.closed) length += ToMm(Distance(piece.points.back(), piece.points.front()));
  }
  return length;
}

TEST(PiecesOfField, EveryPatternGivesTheMeanDensity) {
  const DensityField density = GridField(3, 64, [](double x, double) { return 0.1 + 0.3 * x / 64; });
  const LayerField field{.density = &density};
  for (const FillPatternInfo& info : kFillPatterns) {
    if (!info.sparse || !info.has_law) continue;
    double length = 0;
    constexpr int kLayers = 16;
    for (int layer = 0; layer < kLayers; ++layer) {
      const auto filled = PiecesOfField(
          Square(64), info.pattern,
          {.z_nm = 200'000 * layer, .layer = layer, .angle_rad = 0.785, .spacing_nm = 400'000}, field);
      ASSERT_TRUE(filled.ok()) << info.name;
      length += LengthMm(*filled);
    }
    const double got = length * 0.4 / (64.0 * 64 * kLayers);
    // Lines along an edge follow the cells' edges; waves have their period over more layers.
    const bool graded = !LineFamiliesOf(info.pattern, {.pitch_nm = 1e6}).empty();
    EXPECT_NEAR(got / 0.25, 1, graded ? 0.02 : 0.12) << info.name;
  }
}

TEST(PiecesOfField, DithersLinesWhereTheFieldSaysSo) {
  DensityField density = GridField(3, 64, [](double x, double) { return 0.5 * x / 64; });
  density.dither = Dither::kFloydSteinberg;
  const LayerField field{.density = &density};
  const auto filled =
      PiecesOfField(Square(64), FillPattern::kGrid, {.spacing_nm = 400'000}, field);
  ASSERT_TRUE(filled.ok());
  EXPECT_NEAR(Area(filled->area) / Area(Square(64)), 0.5, 0.01);
}

TEST(PiecesOfField, StreamlinesStandInForThePattern) {
  StressField stress;
  stress.xx.values = {1};
  const DirectionField directions(stress);
  const LayerField field{.directions = &directions, .plain_density = 0.2};
  const auto filled =
      PiecesOfField(Square(60), FillPattern::kGyroid, {.spacing_nm = 400'000}, field);
  ASSERT_TRUE(filled.ok());
  for (const Piece& piece : filled->pieces) EXPECT_NEAR(piece.points[0].y, piece.points[1].y, 2);
  EXPECT_NEAR(LengthMm(*filled) * 0.4 / 3600, 0.2, 0.01);
}

TEST(PiecesOfField, PathsLieInsideAndKeepTheDensity) {
  const DensityField density = GridField(31, 60, [](double x, double y) { return 0.1 + 0.2 * (x + y) / 60; });
  const LayerField field{.density = &density};
  const MultiPolygon region = Square(60);
  for (const FillPattern pattern : {FillPattern::kRectilinear, FillPattern::kGrid, FillPattern::kCubic, FillPattern::kGyroid}) {
    const auto paths = FillSparse(region, {.pattern = pattern, .anchor_nm = 2'000'000, .anchor_max_nm = 20'000'000, .field = &field});
    ASSERT_TRUE(paths.ok());
    ASSERT_FALSE(paths->empty());
    ExpectInside(*paths, region);
  }
}

}  // namespace
}  // namespace slicefarm::infill
