#include "services/infill/algo/fields/field_cells.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "services/infill/algo/fields/field_samples_test.h"

namespace slicefarm::infill::field_cells_test {
namespace {

DensityField Slope() {
  return GridField(2, 10, [](double x, double) { return x / 10; });
}

TEST(FieldCells, LieOnTheGridOfTheOriginWithTheFieldOfTheirMiddles) {
  const DensityField density = Slope();
  const auto cells =
      FieldCellsOf(MakePolygonsOrDie("(-1 1, 5 1, 5 3, -1 3)"), {.density = &density}, 2);
  ASSERT_TRUE(cells.ok());
  EXPECT_EQ(cells->first_x, -1);
  EXPECT_EQ(cells->first_y, 0);
  ASSERT_EQ(cells->width, 4);
  ASSERT_EQ(cells->height, 2);
  for (int y = 0; y < 2; ++y) {
    EXPECT_DOUBLE_EQ(cells->density[static_cast<size_t>(4 * y)], 0);
    EXPECT_DOUBLE_EQ(cells->density[static_cast<size_t>(4 * y + 2)], 0.3);
  }
}

TEST(FieldCells, AreTouchedWhereTheRegionHasArea) {
  const DensityField density = Slope();
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 8 0, 8 8, 6 8, 6 2, 0 2)");
  const auto cells = FieldCellsOf(region, {.density = &density}, 2);
  ASSERT_TRUE(cells.ok());
  for (int64_t y = 0; y < 4; ++y)
    for (int64_t x = 0; x < 4; ++x)
      EXPECT_EQ(cells->touched[static_cast<size_t>(4 * y + x)] != 0, y == 0 || x == 3);
}

TEST(FieldCells, PartARegionWithoutLoss) {
  const DensityField density = Slope();
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 9 1, 7 9, 2 6)");
  const auto cells = FieldCellsOf(region, {.density = &density}, 1);
  ASSERT_TRUE(cells.ok());
  std::vector<char> even(cells->touched.size()), odd(cells->touched.size());
  for (size_t i = 0; i < even.size(); ++i) {
    const auto place = static_cast<int64_t>(i);
    (((place % cells->width + place / cells->width) % 2 == 0) ? even : odd)[i] = 1;
  }
  const MultiPolygon first = PartInCells(region, *cells, even);
  const MultiPolygon second = PartInCells(region, *cells, odd);
  EXPECT_NEAR((Area(first) + Area(second)) / Area(region), 1, 1e-6);
  EXPECT_NEAR(Area(Intersection(first, second)) / Area(region), 0, 1e-6);
}

TEST(FieldCells, RefuseTooMany) {
  const DensityField density = Slope();
  const auto cells =
      FieldCellsOf(MakePolygonsOrDie("(0 0, 900 0, 900 900, 0 900)"), {.density = &density}, 0.5);
  EXPECT_EQ(DetailOf(cells.status()).reason, Reason::kRequestTooLarge);
}

}  // namespace
}  // namespace slicefarm::infill::field_cells_test
