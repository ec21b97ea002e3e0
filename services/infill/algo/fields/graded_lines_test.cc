#include "services/infill/algo/fields/graded_lines.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/geometry/text_format_test.h"
#include "services/infill/algo/fields/field_samples_test.h"

namespace slicefarm::infill::graded_lines_test {
namespace {

constexpr double kSpacingNm = 400'000;

std::vector<Polyline> LinesOf(const std::vector<Piece>& pieces) {
  std::vector<Polyline> lines;
  for (const Piece& piece : pieces) lines.push_back(piece.points);
  return lines;
}

TEST(RankOf, HalvesAgainAndAgain) {
  const double eighths[] = {0, 4, 2, 6, 1, 5, 3, 7};
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(RankOf(i), eighths[i] / 8, 1e-9) << i;
  for (int first : {-1000, -3, 0, 77}) {
    int below = 0;  // a quarter of 64 consecutive lines
    for (int i = 0; i < 64; ++i) below += RankOf(first + i) < 0.25;
    EXPECT_EQ(below, 16) << first;
  }
}

/// Returns the mean absolute error of a field's lines in cells of 5 mm, on average over `layers`,
/// relative to the requested density.
double MeanError(const DensityField& density, int layers) {
  const MultiPolygon region = MakePolygonsOrDie("(-5 -5, 65 -5, 65 65, -5 65)");
  const LayerField field{.density = &density};
  std::vector<Polyline> lines;
  for (int layer = 0; layer < layers; ++layer) {
    const LineFamily family{layer % 2 * std::numbers::pi / 2, 200'000.0 * layer,
                            kSpacingNm / density.Greatest()};
    const auto pieces =
        GradedPieces(region, {&family, 1}, field,
                     {.greatest = density.Greatest(), .min_length_nm = 4 * kSpacingNm});
    EXPECT_TRUE(pieces.ok());
    for (Polyline& line : LinesOf(*pieces)) lines.push_back(std::move(line));
  }
  const auto got = LengthByCell(lines, 60, 5);
  double error = 0;
  for (size_t i = 0; i < got.size(); ++i) {
    double asked = 0;
    for (int k = 0; k < 100; ++k)
      asked +=
          field.DensityAt((i % 12) * 5 + k % 10 * 0.5 + 0.25, (i / 12) * 5 + k / 10 * 0.5 + 0.25) /
          100;
    error += std::abs(got[i] * kSpacingNm * 1e-6 / (25 * layers) / asked - 1);
  }
  return error / static_cast<double>(got.size());
}

TEST(GradedPieces, GiveTheFieldInEachCell) {
  const struct {
    const char* name;
    std::function<double(double, double)> value;
  } cases[] = {
      {"constant", [](double, double) { return 0.2; }},
      {"across", [](double x, double) { return 0.1 + 0.5 * x / 60; }},
      {"aslant", [](double x, double y) { return 0.1 + 0.25 * (x + y) / 60; }},
      {"a bump",
       [](double x, double y) {
         return 0.1 + 0.5 * std::max(0.0, 1 - ((x - 30) * (x - 30) + (y - 30) * (y - 30)) / 900);
       }},
  };
  for (const auto& c : cases) EXPECT_LE(MeanError(GridField(61, 60, c.value), 40), 0.05) << c.name;
}

TEST(GradedPieces, AreTheWholeFamilyWhereTheFieldIsGreatest) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20)");
  const DensityField density = GridField(2, 20, [](double, double) { return 0.4; });
  const LayerField field{.density = &density};
  const LineFamily family{0, 0, 1e6};
  const auto pieces = GradedPieces(region, {&family, 1}, field, {.greatest = 0.4});
  ASSERT_TRUE(pieces.ok());
  EXPECT_EQ(pieces->size(), 20u);
  for (const Piece& piece : *pieces) {
    EXPECT_EQ(piece.from.ring, 0);
    EXPECT_EQ(piece.to.ring, 0);
  }
}

TEST(GradedPieces, EndInsideWhereTheFieldFallsBelowTheirRank) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20)");
  const DensityField density =
      GridField(2, 20, [](double x, double) { return 0.4 * (1 - x / 20); });
  const LayerField field{.density = &density};
  const LineFamily family{0, 0, 1e6};
  const auto pieces =
      GradedPieces(region, {&family, 1}, field, {.greatest = 0.4, .min_length_nm = 1e6});
  ASSERT_TRUE(pieces.ok());
  for (const Piece& piece : *pieces) {
    const auto line = piece.points[0].y / 1'000'000;
    EXPECT_NEAR(ToMm(piece.points[1].x), 20 * (1 - RankOf(line)), 0.01) << line;
    EXPECT_EQ(piece.from.ring, 0);
    EXPECT_EQ(piece.to.ring, -1);
  }
}

}  // namespace
}  // namespace slicefarm::infill::graded_lines_test
