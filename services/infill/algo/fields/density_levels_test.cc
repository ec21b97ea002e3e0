#include "services/infill/algo/fields/density_levels.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "services/infill/algo/fields/field_samples_test.h"

namespace slicefarm::infill::density_levels_test {
namespace {

MultiPolygon Square(double from_mm, double to_mm) {
  const Coord a = FromMm(from_mm), b = FromMm(to_mm);
  return {{{{a, a}, {b, a}, {b, b}, {a, b}}, {}}};
}

std::vector<DensityPart> PartsAt(const MultiPolygon& region, const DensityField& density,
                                 double z_mm) {
  auto parts = LevelParts(region, {.density = &density, .z_mm = z_mm}, 2);
  EXPECT_TRUE(parts.ok());
  return *std::move(parts);
}

/// Returns the mean density of a region over two periods, in layers of 0.2 mm.
double MeanOver(const MultiPolygon& region, const DensityField& density) {
  constexpr int kLayers = 40;
  double sum = 0;
  for (int i = 0; i < kLayers; ++i)
    for (const DensityPart& part : PartsAt(region, density, 0.2 * i + 0.1))
      sum += part.density * Area(part.area);
  return sum / (kLayers * Area(region));
}

TEST(LevelParts, HoldTheDensityAskedForOverASwing) {
  for (const double asked : {0.004, 0.05, 0.11, 0.2, 0.33, 0.6}) {
    const DensityField density = GridField(41, 40, [=](double, double y) {
      return y > 39 ? 0.6 : asked;  // the nodes at the edge have the greatest density
    });
    EXPECT_NEAR(MeanOver(Square(0, 0.5), density) / asked, 1, 0.03) << asked;
  }
}

TEST(LevelParts, FollowAGradientInEachCellOf5Mm) {
  const DensityField density =
      GridField(41, 80, [](double x, double y) { return 0.1 + 0.2 * (x + y) / 80; });
  for (double at = 0; at < 80; at += 5) {
    const double asked = 0.1 + 0.2 * (2 * at + 5) / 80;
    EXPECT_NEAR(MeanOver(Square(at, at + 5), density) / asked, 1, 0.04) << at;
  }
}

TEST(LevelParts, PartTheRegionWithNothingTwice) {
  const DensityField density = GridField(41, 80, [](double x, double) { return 0.5 * x / 80; });
  const MultiPolygon region = Difference(Square(0, 80), Square(30, 50));
  double area = 0;
  MultiPolygon all;
  for (const DensityPart& part : PartsAt(region, density, 1)) {
    EXPECT_GT(part.density, 0);
    EXPECT_LE(part.density, 0.5);
    area += Area(part.area);
    all = Union(all, part.area);
  }
  EXPECT_NEAR(Area(all) / area, 1, 1e-9);
  EXPECT_TRUE(Difference(all, region).empty());
  EXPECT_GT(area / Area(region), 0.97) << "only the emptiest end is left out";
}

TEST(LevelParts, AreWholeWhereTheFieldIsSmooth) {
  const DensityField density =
      GridField(3, 80, [](double x, double) { return 0.1 + 0.4 * x / 80; });
  for (double z = 0.1; z < 4; z += 0.4) {
    const std::vector<DensityPart> parts = PartsAt(Square(0, 80), density, z);
    ASSERT_FALSE(parts.empty()) << z;
    for (const DensityPart& part : parts)
      EXPECT_EQ(part.area.size(), 1u) << "level " << part.density << " at " << z;
  }
}

TEST(LevelParts, AreNoneWhereNothingIsAsked) {
  const DensityField nothing = GridField(2, 40, [](double, double) { return 0.0; });
  EXPECT_TRUE(PartsAt(Square(0, 40), nothing, 1).empty());
  EXPECT_TRUE(PartsAt({}, nothing, 1).empty());
}

TEST(LevelParts, RefuseTooManyCells) {
  const DensityField density = GridField(2, 900, [](double, double) { return 0.2; });
  const auto parts = LevelParts(Square(0, 900), {.density = &density}, 0.5);
  EXPECT_EQ(DetailOf(parts.status()).reason, Reason::kRequestTooLarge);
}

}  // namespace
}  // namespace slicefarm::infill::density_levels_test
