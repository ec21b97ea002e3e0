#include "common/model/fields/field_grid.h"

#include <gtest/gtest.h>

namespace slicefarm::field_grid_test {
namespace {

/// Returns a grid with values a + b x + c y + d z: linear interpolation reproduces them exactly.
FieldGrid LinearGrid() {
  FieldGrid grid{{3, 4, 2}, {-1, 2, 0.5}, {2, 1, 4}, {}};
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 3; ++x)
        grid.values.push_back(0.5 + 0.25 * (-1 + 2 * x) - 0.125 * (2 + y) + 2 * (0.5 + 4 * z));
  return grid;
}

TEST(FieldGrid, IsLinearBetweenNodes) {
  const FieldGrid grid = LinearGrid();
  for (const PositionMm& position : {PositionMm{-1, 2, 0.5}, PositionMm{0.3, 3.7, 2},
                                     PositionMm{3, 5, 4.5}, PositionMm{2.99, 4.01, 1}})
    EXPECT_NEAR(grid.At(position), 0.5 + 0.25 * position[0] - 0.125 * position[1] + 2 * position[2],
                1e-12);
}

TEST(FieldGrid, HoldsTheNearestValueBeyondItsBox) {
  const FieldGrid grid = LinearGrid();
  EXPECT_EQ(grid.At({-100, 3.5, 2}), grid.At({-1, 3.5, 2}));
  EXPECT_EQ(grid.At({1, 99, -7}), grid.At({1, 5, 0.5}));
  EXPECT_EQ(grid.At({1e9, 1e9, 1e9}), grid.values.back());
}

TEST(FieldGrid, OfOneNodeIsConstant) {
  const FieldGrid grid{{1, 1, 1}, {0, 0, 0}, {1, 1, 1}, {0.7}};
  EXPECT_EQ(grid.At({5, -3, 2}), 0.7);
}

TEST(FieldGrid, SameNodesLooksAtNoValues) {
  const FieldGrid a = LinearGrid();
  FieldGrid b = a;
  b.values[3] += 1;
  EXPECT_TRUE(SameNodes(a, b));
  b.origin_mm[1] += 1;
  EXPECT_FALSE(SameNodes(a, b));
}

}  // namespace
}  // namespace slicefarm::field_grid_test
