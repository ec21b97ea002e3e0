#include "services/texture/algo/pattern/computed_heights.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/base/error.h"

namespace slicefarm::texture::computed_heights_test {
namespace {

HeightGrid HeightsOf(const std::string& text) {
  const auto grid = ComputedHeights(*ParseTextureSpec(text));
  EXPECT_TRUE(grid.ok()) << grid.status();
  return *grid;
}

class HeightsOfKind : public testing::TestWithParam<TextureKindInfo> {};

TEST_P(HeightsOfKind, GoesFromTheBaseToItsHeight) {
  const HeightGrid grid = HeightsOf(std::string(GetParam().name) + ":height=0.7,detail=48");
  const auto [low, high] = std::minmax_element(grid.heights_mm.begin(), grid.heights_mm.end());
  EXPECT_GE(*low, 0);
  EXPECT_LE(*low, 0.2 * 0.7);
  EXPECT_LE(*high, 0.7 + 1e-12);
  EXPECT_GE(*high, 0.8 * 0.7);
}

/// A tile has no seam: steps between neighbours across its border are no larger than inside.
TEST_P(HeightsOfKind, TilesWithoutSeams) {
  const HeightGrid grid = HeightsOf(std::string(GetParam().name));
  double inside = 0, across = 0;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const double here = grid.NodeMm(column, row);
      const double right = std::abs(grid.NodeMm(column + 1, row) - here);
      const double up = std::abs(grid.NodeMm(column, row + 1) - here);
      (column + 1 == grid.columns ? across : inside) =
          std::max(column + 1 == grid.columns ? across : inside, right);
      (row + 1 == grid.rows ? across : inside) =
          std::max(row + 1 == grid.rows ? across : inside, up);
    }
  }
  EXPECT_LE(across, inside + 1e-12);
}

/// A texture with twice the pitch is the same texture, enlarged.
TEST_P(HeightsOfKind, ScalesWithItsPitch) {
  const std::string name(GetParam().name);
  const HeightGrid one = HeightsOf(name + ":pitch=2"), two = HeightsOf(name + ":pitch=4");
  EXPECT_EQ(one.heights_mm, two.heights_mm);
  EXPECT_EQ(2 * one.size_mm, two.size_mm);
}

INSTANTIATE_TEST_SUITE_P(Textures, HeightsOfKind, testing::ValuesIn(kTextureKinds),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(ComputedHeights, HaveTheirShapes) {
  const HeightGrid pyramid = HeightsOf("pyramids:height=1,pitch=4,size=1,detail=40");
  EXPECT_NEAR(pyramid.At({2, 2}), 1, 1e-12);
  EXPECT_NEAR(pyramid.At({1, 2.5}), 0.5, 1e-12);
  EXPECT_NEAR(pyramid.At({0, 0}), 0, 1e-12);
  const HeightGrid bump = HeightsOf("bumps:height=1,pitch=4,size=1,detail=400");
  EXPECT_NEAR(bump.At({2 + 1.2, 2}), 0.8, 1e-3);  // 3-4-5
  const HeightGrid groove = HeightsOf("grooves:height=1,pitch=1,size=0.5,slope=0.1,detail=100");
  EXPECT_NEAR(groove.At({0.5, 0.3}), 1, 1e-12);
  EXPECT_NEAR(groove.At({0.3, 0.7}), 0.5, 1e-9);
  EXPECT_NEAR(groove.At({0.1, 0.7}), 0, 1e-12);
}

TEST(ComputedHeights, SeedsDiffer) {
  EXPECT_NE(HeightsOf("noise:seed=1").heights_mm, HeightsOf("noise:seed=2").heights_mm);
  EXPECT_NE(HeightsOf("cells:seed=1").heights_mm, HeightsOf("cells:seed=2").heights_mm);
}

TEST(ComputedHeights, RefusesTooManyNodes) {
  const auto grid = ComputedHeights(*ParseTextureSpec("noise:count=64,detail=400"));
  ASSERT_FALSE(grid.ok());
  EXPECT_EQ(DetailOf(grid.status()).reason, Reason::kRequestTooLarge);
}

}  // namespace
}  // namespace slicefarm::texture::computed_heights_test
