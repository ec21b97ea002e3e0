#include "services/infill/algo/fields/dither.h"

#include <gtest/gtest.h>

#include <numeric>

#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "services/infill/algo/fields/field_samples_test.h"

namespace slicefarm::infill::dither_test {
namespace {

double MeanOf(const std::vector<char>& cells) {
  return std::accumulate(cells.begin(), cells.end(), 0.0) / static_cast<double>(cells.size());
}

TEST(FloydSteinberg, LosesNothingAtEdges) {
  for (const double value : {0.0, 0.01, 0.1, 0.3, 0.5, 0.77, 1.0}) {
    const auto cells = FloydSteinberg(std::vector<double>(64 * 64, value), {}, 64, 64);
    EXPECT_NEAR(MeanOf(cells), value, 0.5 / (64 * 64) + 1e-12) << value;
  }
}

TEST(FloydSteinberg, GoesOnInTheLayoutOfItsAuthors) {
  // A cell of 0.4 gives 7/16 of it to the right, and 3/16, 5/16 and 1/16 to the next row.
  const auto cells = FloydSteinberg({0, 0.4, 0.33, 0, 0.3, 0.49, 0.47, 0, 0}, {}, 3, 3);
  // 0.33 + 0.4 * 7/16 = 0.505: on, with error -0.495; 0.3 + 0.4 * 3/16 stays off.
  EXPECT_EQ(cells[1], 0);
  EXPECT_EQ(cells[2], 1);
  EXPECT_EQ(cells[3], 0);
}

TEST(FloydSteinberg, KeepsToTheCellsThatAreUsed) {
  std::vector<char> used(40 * 40, 0);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x)
      used[static_cast<size_t>(y * 40 + x)] = (x - 20) * (x - 20) + (y - 20) * (y - 20) < 300;
  const auto cells = FloydSteinberg(std::vector<double>(1600, 0.3), used, 40, 40);
  double on = 0, all = 0;
  for (size_t i = 0; i < used.size(); ++i) {
    ASSERT_LE(cells[i], used[i]);
    on += cells[i], all += used[i];
  }
  EXPECT_NEAR(on / all, 0.3, 0.005);
}

TEST(DitheredRegion, CoversTheShareThatIsAskedFor) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 128 0, 128 128, 0 128)");
  for (const Dither dither : {Dither::kBlueNoise, Dither::kFloydSteinberg}) {
    for (const double asked : {0.05, 0.2, 0.5, 0.6}) {
      const DensityField density = GridField(2, 128, [&](double, double) { return asked; });
      const LayerField field{.density = &density};
      const double share =
          Area(*DitheredRegion(region, field, dither, 0.8, 2)) / Area(region) * 0.8;
      EXPECT_NEAR(share / asked, 1, 0.005) << asked;
    }
  }
}

TEST(DitheredRegion, FollowsAGradient) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 128 0, 128 128, 0 128)");
  const DensityField density = GridField(3, 128, [](double x, double) { return 0.6 * x / 128; });
  const LayerField field{.density = &density};
  for (const Dither dither : {Dither::kBlueNoise, Dither::kFloydSteinberg}) {
    const double mean = 0.6 * Area(*DitheredRegion(region, field, dither, 0.6, 2)) / Area(region);
    EXPECT_NEAR(mean, 0.3, 0.005 * 0.3);
  }
}

TEST(DitheredRegion, RefusesTooManyCells) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 900 0, 900 900, 0 900)");
  const DensityField density = GridField(2, 900, [](double, double) { return 0.2; });
  const LayerField field{.density = &density};
  const auto dithered = DitheredRegion(region, field, Dither::kBlueNoise, 0.2, 0.5);
  EXPECT_EQ(DetailOf(dithered.status()).reason, Reason::kRequestTooLarge);
}

TEST(DitheredRegion, IsNothingWhereNothingIsAsked) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)");
  const DensityField density = GridField(2, 10, [](double, double) { return 0.0; });
  const LayerField field{.density = &density};
  EXPECT_TRUE(DitheredRegion(region, field, Dither::kFloydSteinberg, 0.5, 2)->empty());
  EXPECT_TRUE(DitheredRegion({}, field, Dither::kBlueNoise, 0.5, 2)->empty());
}

}  // namespace
}  // namespace slicefarm::infill::dither_test
