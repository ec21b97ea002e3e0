#include "services/texture/algo/pattern/texture_file.h"

#include <gtest/gtest.h>

#include <limits>

#include "common/base/error.h"
#include "services/texture/algo/output/displaced_mesh.h"
#include "services/texture/algo/surface/sample_surfaces_test.h"

namespace slicefarm::texture::texture_file_test {
namespace {

TEST(TextureOfFile, ReadsASolid) {
  const SurfaceMesh sphere = Sphere(6, 2);
  const auto texture = TextureOfFile(StlBytes(sphere), {});
  ASSERT_TRUE(texture.ok()) << texture.status();
  EXPECT_EQ(texture->solid.triangles.size(), sphere.triangles.size());
  EXPECT_EQ(texture->solid.points_mm.size(), sphere.points_mm.size()) << "welded";
  EXPECT_NEAR(texture->height_mm, 4, 1e-6);
}

TEST(TextureOfFile, RefusesWhatIsNeither) {
  const auto reason = [](std::string_view bytes) {
    return DetailOf(TextureOfFile(bytes, {}).status()).reason;
  };
  EXPECT_EQ(reason(""), Reason::kMeshTruncated);
  EXPECT_EQ(reason("solid text"), Reason::kMeshTruncated);
  const std::string stl = StlBytes(Sphere(4, 2));
  EXPECT_EQ(reason(std::string_view(stl).substr(0, stl.size() - 1)), Reason::kMeshTruncated);
  EXPECT_EQ(reason("\x89PNG\r\n\x1a\n"), Reason::kRequestMalformed);
  std::string many(84, '\xff');
  EXPECT_EQ(reason(many), Reason::kMeshTooLarge);
  SurfaceMesh bad = Sphere(4, 2);
  bad.points_mm[0].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(reason(StlBytes(bad)), Reason::kMeshNotFinite);
  bad.points_mm[0].y() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(reason(StlBytes(bad)), Reason::kMeshNotFinite);
}

}  // namespace
}  // namespace slicefarm::texture::texture_file_test
