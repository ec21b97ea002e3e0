#include "services/infill/algo/fields/mean_density.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"
#include "services/infill/algo/fields/field_samples_test.h"

namespace slicefarm::infill::mean_density_test {
namespace {

double MeanIn(const char* region, const DensityField& density) {
  const LayerField field{.density = &density};
  const auto mean = MeanDensity(MakePolygonsOrDie(region), field);
  EXPECT_TRUE(mean.ok()) << mean.status();
  return mean.value_or(-1);
}

DensityField Rising() {
  return GridField(41, 40, [](double x, double) { return 0.1 + 0.01 * x; });
}

TEST(MeanDensity, IsTheFieldsOverTheRegion) {
  struct Case {
    const char* name;
    const char* region;
    double want;
  };
  // The mean of a triangle with a side along y is at a third of its height.
  const Case cases[] = {{"all", "(0 0, 40 0, 40 40, 0 40)", 0.3},
                        {"left half", "(0 0, 20 0, 20 40, 0 40)", 0.2},
                        {"islands", "(0 0, 10 0, 10 10, 0 10) ; (30 0, 40 0, 40 10, 30 10)", 0.3},
                        {"triangle", "(0 0, 40 20, 0 40)", 0.1 + 0.4 / 3},
                        {"frame", "(0 0, 40 0, 40 40, 0 40) (1 1, 1 39, 39 39, 39 1)", 0.3}};
  for (const Case& c : cases) EXPECT_NEAR(MeanIn(c.region, Rising()), c.want, 0.002) << c.name;
}

TEST(MeanDensity, OfWhatNoLineMeetsIsThatOfItsMiddle) {
  EXPECT_NEAR(MeanIn("(20 0.5, 22 0.5, 22 1.5, 20 1.5)", Rising()), 0.31, 1e-6);
}

TEST(MeanDensity, WithoutAFieldOfDensitiesIsThePlainOne) {
  const LayerField field{.plain_density = 0.35};
  EXPECT_EQ(*MeanDensity(MakePolygonsOrDie("(0 0, 1 0, 1 1)"), field), 0.35);
}

}  // namespace
}  // namespace slicefarm::infill::mean_density_test
