#include "common/model/fields/density_field.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slicefarm::density_field_test {
namespace {

TEST(DensityOf, IsWhatEachLawSays) {
  struct Case {
    const char* name;
    DensityLaw law;
    double steepness, threshold, value, density;
  };
  const Case cases[] = {
      {"linear", DensityLaw::kLinear, 3, 0.5, 0.37, 0.37},
      {"SIMP of a half", DensityLaw::kSimp, 3, 0.5, 0.5, 0.125},
      {"SIMP, p = 2.5", DensityLaw::kSimp, 2.5, 0.5, 0.4, std::pow(0.4, 2.5)},
      {"SIMP of 0", DensityLaw::kSimp, 3, 0.5, 0, 0},
      {"SIMP of 1", DensityLaw::kSimp, 3, 0.5, 1, 1},
      {"RAMP, q = 3", DensityLaw::kRamp, 3, 0.5, 0.25, 0.0769231},
      {"RAMP of a half", DensityLaw::kRamp, 3, 0.5, 0.5, 0.2},
      {"RAMP of three quarters", DensityLaw::kRamp, 3, 0.5, 0.75, 0.4285714},
      {"Heaviside, b = 8", DensityLaw::kHeaviside, 8, 0.5, 0.25, 0.0176627},
      {"Heaviside in its middle", DensityLaw::kHeaviside, 8, 0.5, 0.5, 0.5},
      {"Heaviside of 0", DensityLaw::kHeaviside, 8, 0.5, 0, 0},
      {"Heaviside of 1", DensityLaw::kHeaviside, 8, 0.3, 1, 1},
  };
  for (const Case& c : cases)
    EXPECT_NEAR(DensityOf(c.value, c.law, c.steepness, c.threshold), c.density, 5e-8) << c.name;
}

TEST(DensityOf, RisesWithItsValue) {
  for (const DensityLaw law :
       {DensityLaw::kLinear, DensityLaw::kSimp, DensityLaw::kRamp, DensityLaw::kHeaviside}) {
    double last = -1;
    for (int i = 0; i <= 100; ++i) {
      const double density = DensityOf(i / 100.0, law, 4, 0.4);
      EXPECT_GT(density, last);
      EXPECT_LE(density, 1);
      last = density;
    }
  }
}

TEST(DensityField, ByHeightIsTheSameAllOverALayer) {
  const DensityField field{.at_mm = {0, 10}, .values = {0.1, 0.5}};
  EXPECT_DOUBLE_EQ(field.UniformAt(2.5).value(), 0.2);
  EXPECT_DOUBLE_EQ(field.UniformAt(-1).value(), 0.1);
  EXPECT_DOUBLE_EQ(field.UniformAt(99).value(), 0.5);
  EXPECT_DOUBLE_EQ(field.At({7, 7, 5}, 0), 0.3);
  EXPECT_DOUBLE_EQ(field.Greatest(), 0.5);
  EXPECT_DOUBLE_EQ(field.Least(), 0.1);
  EXPECT_EQ(field.ReachMm(), 0);
}

TEST(DensityField, ByDistanceReachesAsFarAsItsTable) {
  const DensityField field{
      .kind = DensityField::Kind::kSurfaceDistance, .at_mm = {0, 4}, .values = {0.6, 0.2}};
  EXPECT_FALSE(field.UniformAt(1).has_value());
  EXPECT_DOUBLE_EQ(field.At({0, 0, 0}, 1), 0.5);
  EXPECT_DOUBLE_EQ(field.At({0, 0, 0}, 50), 0.2);
  EXPECT_EQ(field.ReachMm(), 4);
}

TEST(DensityField, OfAGridIsUniformWhereItsSheetsAre) {
  DensityField field{.kind = DensityField::Kind::kGrid,
                     .grid = {{2, 1, 1}, {0, 0, 0}, {1, 1, 1}, {0.3, 0.3}}};
  EXPECT_EQ(field.UniformAt(1), 0.3);
  field.grid.values[1] = 0.4;
  EXPECT_FALSE(field.UniformAt(1).has_value());
  EXPECT_EQ(field.Greatest(), 0.4);
  field.grid = {{2, 1, 3}, {0, 0, 0}, {1, 1, 2}, {0.1, 0.1, 0.3, 0.3, 0.2, 0.4}};
  EXPECT_DOUBLE_EQ(field.UniformAt(1).value(), 0.2);
  EXPECT_EQ(field.UniformAt(-3), 0.1);
  EXPECT_FALSE(field.UniformAt(2.5).has_value());
  EXPECT_FALSE(field.UniformAt(9).has_value());
}

}  // namespace
}  // namespace slicefarm::density_field_test
