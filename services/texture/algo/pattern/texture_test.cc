#include "services/texture/algo/pattern/texture.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/texture/algo/pattern/computed_heights.h"
#include "services/texture/algo/surface/sample_surfaces_test.h"

namespace slicefarm::texture::texture_test {
namespace {

TEST(TextureOf, HeightsBecomeASolid) {
  const auto texture = TextureOf(*ComputedHeights(*ParseTextureSpec("bumps:height=0.6,detail=10")));
  ASSERT_TRUE(texture.ok()) << texture.status();
  EXPECT_EQ(texture->tile_mm, Eigen::Vector2d(4, 4));
  EXPECT_DOUBLE_EQ(texture->height_mm, 0.6);
  EXPECT_EQ(texture->solid.triangles.size(), 2u * 10 * 10 + 2 * 40);
}

TEST(TextureOf, ASolidIsMovedToTheOrigin) {
  SurfaceMesh sphere = Sphere(8, 2);
  for (Eigen::Vector3d& p : sphere.points_mm) p += Eigen::Vector3d(10, -7, 3);
  const auto texture = TextureOf(sphere, {5, 0});
  ASSERT_TRUE(texture.ok()) << texture.status();
  EXPECT_NEAR(texture->tile_mm.x(), 5, 1e-12);
  EXPECT_NEAR(texture->tile_mm.y(), 4, 1e-9);
  EXPECT_NEAR(texture->height_mm, 4, 1e-9);
  EXPECT_NEAR(texture->heights.At({2, 2}), 4, 0.05);
  EXPECT_EQ(texture->heights.At({4.5, 2}), 0) << "beside the solid";
}

TEST(TextureOf, RefusesWhatIsNoSolid) {
  const auto reason = [](const absl::StatusOr<Texture>& texture) {
    return DetailOf(texture.status()).reason;
  };
  EXPECT_EQ(reason(TextureOf(SurfaceMesh{}, {0, 0})), Reason::kMeshEmpty);
  EXPECT_EQ(reason(TextureOf(FlatSquare(2, 3), {0, 0})), Reason::kNothingToPrint);
  EXPECT_EQ(reason(TextureOf(Sphere(4, 2), {3, 3})), Reason::kSettingOutOfRange);
  SurfaceMesh bad = Sphere(4, 2);
  bad.triangles[3][1] = 100'000;
  EXPECT_EQ(reason(TextureOf(bad, {0, 0})), Reason::kMeshMalformed);
  bad = Sphere(4, 2);
  bad.points_mm[1].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(reason(TextureOf(bad, {0, 0})), Reason::kMeshNotFinite);
  EXPECT_EQ(reason(TextureOf(HeightGrid{2, 2, {1, 1}, {0, 0, 0, 0}})), Reason::kNothingToPrint);
}

}  // namespace
}  // namespace slicefarm::texture::texture_test
