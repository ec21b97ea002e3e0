#include "services/texture/algo/pattern/height_grid.h"

#include <gtest/gtest.h>

namespace slicefarm::texture::height_grid_test {
namespace {

HeightGrid Sample() { return {3, 2, {6, 4}, {0, 1, 2, 3, 4, 9}}; }

TEST(HeightGrid, HasItsNodesHeights) {
  const HeightGrid grid = Sample();
  for (int row = -2; row < 4; ++row)
    for (int column = -3; column < 6; ++column)
      EXPECT_DOUBLE_EQ(grid.At(grid.NodePosition(column, row)), grid.NodeMm(column, row))
          << column << " " << row;
}

TEST(HeightGrid, Repeats) {
  const HeightGrid grid = Sample();
  for (const auto& p : {Eigen::Vector2d(0.7, 1.1), {5.9, 3.9}, {3.3, 2.5}})
    EXPECT_NEAR(grid.At(p), grid.At(p + Eigen::Vector2d(-6, 8)), 1e-12);
}

TEST(HeightGrid, IsLinearBetweenNodes) {
  const HeightGrid grid = Sample();
  EXPECT_NEAR(grid.At({1, 0}), 0.5, 1e-12);
  EXPECT_NEAR(grid.At({0, 1}), 1.5, 1e-12);
  // Cell (0, 0) has the heights 0 1 / 3 4. Its falling diagonal, from 1 to 3, has a smaller
  // difference than the one from 0 to 4.
  EXPECT_FALSE(grid.CutFromNode(0, 0));
  EXPECT_NEAR(grid.At({1, 1}), 2, 1e-12);
}

}  // namespace
}  // namespace slicefarm::texture::height_grid_test
