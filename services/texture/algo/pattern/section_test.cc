#include "services/texture/algo/pattern/section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "services/texture/algo/pattern/computed_heights.h"
#include "services/texture/algo/surface/sample_surfaces_test.h"

namespace slicefarm::texture::section_test {
namespace {

Texture Made(const std::string& text) {
  return *TextureOf(*ComputedHeights(*ParseTextureSpec(text)));
}

class SectionOfKind : public testing::TestWithParam<TextureKindInfo> {};

/// Returns positions in the tile that are on no line of nodes.
std::vector<Eigen::Vector2d> Places(const Texture& texture) {
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < 400; ++i)
    places.push_back(texture.tile_mm.cwiseProduct(
        Eigen::Vector2d(i * 0.61803 - std::floor(i * 0.61803), (i + 0.37) / 400)));
  return places;
}

TEST_P(SectionOfKind, IsSolidWhereTheTextureIsHigher) {
  const Texture texture = Made(std::string(GetParam().name) + ":height=1");
  const double heights[] = {0.05, 0.35, 0.65, 0.95};
  const auto sections = SectionsOf(texture, heights);
  ASSERT_EQ(sections.size(), 4u);
  for (size_t k = 0; k < 4; ++k)
    for (const Eigen::Vector2d& p : Places(texture)) {
      if (std::abs(texture.heights.At(p) - heights[k]) < 1e-9) continue;
      EXPECT_EQ(sections[k].Contains(p), texture.heights.At(p) > heights[k]) << p.transpose();
    }
}

/// The area equals the area where the heights are above the section, by sampling; it shrinks with
/// the height.
TEST_P(SectionOfKind, HasItsArea) {
  const Texture texture = Made(std::string(GetParam().name) + ":height=1,detail=20");
  const double heights[] = {0.2, 0.5, 0.8};
  const auto sections = SectionsOf(texture, heights);
  for (size_t k = 0; k < 3; ++k) {
    int above = 0;
    constexpr int kSide = 300;
    for (int i = 0; i < kSide * kSide; ++i) {
      const Eigen::Vector2d share((i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide);
      above += texture.heights.At(texture.tile_mm.cwiseProduct(share)) > heights[k];
    }
    const double tile = texture.tile_mm.prod();
    EXPECT_NEAR(sections[k].AreaMm2() / tile, above / double{kSide * kSide}, 0.01);
    if (k > 0) {
      EXPECT_LE(sections[k].AreaMm2(), sections[k - 1].AreaMm2() + 1e-12);
    }
  }
}

TEST_P(SectionOfKind, CrossingsLieBetweenInsideAndOutside) {
  const Texture texture = Made(std::string(GetParam().name) + ":height=1");
  const double height[] = {0.47};
  const auto sections = SectionsOf(texture, height);
  const auto places = Places(texture);
  for (size_t i = 0; i + 1 < places.size(); ++i) {
    std::vector<double> shares = {0, 1};
    sections[0].Crossings(places[i], places[i + 1], &shares);
    std::sort(shares.begin(), shares.end());
    for (size_t k = 0; k + 1 < shares.size(); ++k) {
      // The state does not change between two crossings.
      const auto at = [&](double t) {
        const double share = shares[k] + t * (shares[k + 1] - shares[k]);
        return sections[0].Contains(places[i] + share * (places[i + 1] - places[i]));
      };
      if (shares[k + 1] - shares[k] < 1e-9) continue;
      EXPECT_EQ(at(0.01), at(0.5));
      EXPECT_EQ(at(0.99), at(0.5));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Textures, SectionOfKind, testing::ValuesIn(kTextureKinds),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(SectionsOf, ASphereIsCutInCircles) {
  const Texture sphere = *TextureOf(Sphere(40, 2), {0, 0});
  const double heights[] = {0.4, 2, 3.2};
  const auto sections = SectionsOf(sphere, heights);
  for (size_t k = 0; k < 3; ++k) {
    const double radius_square = 4 - (heights[k] - 2) * (heights[k] - 2);
    EXPECT_NEAR(sections[k].AreaMm2(), std::numbers::pi * radius_square, 0.02 * radius_square);
    EXPECT_TRUE(sections[k].Contains({2, 2}));
    EXPECT_FALSE(sections[k].Contains({0.05, 0.05}));
  }
}

TEST(SectionsOf, SolidsMayLieInEachOther) {
  SurfaceMesh two = Sphere(10, 2);
  const SurfaceMesh inner = Sphere(10, 1);
  const auto shift = static_cast<int32_t>(two.points_mm.size());
  two.points_mm.insert(two.points_mm.end(), inner.points_mm.begin(), inner.points_mm.end());
  for (auto triangle : inner.triangles) {
    for (int32_t& vertex : triangle) vertex += shift;
    two.triangles.push_back(triangle);
  }
  const double height[] = {2};
  EXPECT_TRUE(SectionsOf(*TextureOf(two, {0, 0}), height)[0].Contains({2, 2}));
}

}  // namespace
}  // namespace slicefarm::texture::section_test
