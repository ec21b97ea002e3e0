#include "services/texture/algo/paths/tiled_section.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "services/texture/algo/pattern/computed_heights.h"

namespace slicefarm::texture::tiled_section_test {
namespace {

constexpr double kHeight = 0.4;

struct Sample {
  Texture texture =
      *TextureOf(*ComputedHeights(*ParseTextureSpec("noise:height=1,pitch=1.5,count=3")));
  std::vector<Section> sections = SectionsOf(texture, std::array{kHeight});
};

TEST(TiledSection, RepeatsTheTexture) {
  const Sample s;
  const Placement placement{.anchor_mm = {3, -2}, .x_axis = {0.6, 0.8}, .scale = 1.7};
  const TiledSection tiled(s.sections[0], s.texture.tile_mm, placement);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d p(i * 0.173 - 40, 30 - i * 0.131);
    const double height = s.texture.heights.At(placement.ToTexture(p));
    if (std::abs(height - kHeight) < 1e-9) continue;
    EXPECT_EQ(tiled.Contains(p), height > kHeight) << p.transpose();
  }
}

TEST(TiledSection, NothingChangesBetweenItsCuts) {
  const Sample s;
  const Placement placement{.x_axis = {0.8, -0.6}};
  const TiledSection tiled(s.sections[0], s.texture.tile_mm, placement);
  for (int i = 0; i < 60; ++i) {
    const Eigen::Vector2d a(i - 20.3, -i * 0.7), b(15.1 - i, i * 0.9 - 11);
    std::vector<double> shares = {0, 1};
    tiled.Cuts(a, b, &shares);
    std::sort(shares.begin(), shares.end());
    EXPECT_GT(shares.size(), 4u);
    for (size_t k = 0; k + 1 < shares.size(); ++k) {
      if (shares[k + 1] - shares[k] < 1e-9) continue;
      const auto at = [&](double t) {
        return tiled.Contains(a + (shares[k] + t * (shares[k + 1] - shares[k])) * (b - a));
      };
      EXPECT_EQ(at(0.01), at(0.5));
      EXPECT_EQ(at(0.99), at(0.5));
    }
  }
}

TEST(TiledSection, IsMetAlongTheBordersOfTiles) {
  const Texture ridges =
      *TextureOf(*ComputedHeights(*ParseTextureSpec("grooves:height=1,pitch=3")));
  const std::vector<Section> sections = SectionsOf(ridges, std::array{0.5});
  const TiledSection tiled(sections[0], ridges.tile_mm, Placement{});
  for (const double y : {-12.0, 0.0, 3.0, 6.0}) {
    for (const bool back : {false, true}) {
      const Eigen::Vector2d left(0.1, y), right(2.9, y);
      std::vector<double> shares;
      tiled.Cuts(back ? right : left, back ? left : right, &shares);
      EXPECT_GE(shares.size(), 2u) << y;
      EXPECT_TRUE(tiled.Contains({1.5, y}));
      EXPECT_FALSE(tiled.Contains({0.2, y}));
    }
  }
}

TEST(TiledSection, MayStandAlone) {
  const Sample s;
  const Placement placement{.repeat = false};
  const TiledSection tiled(s.sections[0], s.texture.tile_mm, placement);
  bool any = false;
  for (int i = 0; i < 900; ++i) {
    const Eigen::Vector2d p((i % 30) * 0.5 - 5, (i / 30) * 0.5 - 5);
    const bool within = p.minCoeff() >= 0 && p.x() < 4.5 && p.y() < 4.5;
    any |= tiled.Contains(p);
    if (!within) {
      EXPECT_FALSE(tiled.Contains(p));
    }
  }
  EXPECT_TRUE(any);
}

}  // namespace
}  // namespace slicefarm::texture::tiled_section_test
