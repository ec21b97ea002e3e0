#include "services/texture/algo/surface_mapping.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/texture/algo/surface/sample_surfaces_test.h"

namespace slicefarm::texture::surface_mapping_test {
namespace {

SurfaceMesh Tetrahedron() {
  return {{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

TEST(MapSurface, CutsWhatIsNoDisk) {
  const auto mapped = MapSurface({Tetrahedron()});
  ASSERT_TRUE(mapped.ok()) << mapped.status();
  EXPECT_GT(mapped->mesh.points_mm.size(), 4u);
  EXPECT_EQ(mapped->vertex_of.size(), mapped->mesh.points_mm.size());
  EXPECT_EQ(mapped->map_mm.size(), mapped->mesh.points_mm.size());
}

TEST(MapSurface, RefusesItIfItMayNotBeCut) {
  EXPECT_EQ(DetailOf(MapSurface({Tetrahedron(), false}).status()).reason, Reason::kMeshMalformed);
}

/// Points that belong to no triangle count too, because they are sent with the map.
TEST(MapSurface, RefusesWhatNoMessageHolds) {
  SurfaceInput surface{HalfCylinder(4, 5, 3)};
  surface.mesh.points_mm.resize(1'200'001, Eigen::Vector3d::Zero());
  EXPECT_EQ(DetailOf(MapSurface(surface).status()).reason, Reason::kMeshTooLarge);
}

}  // namespace
}  // namespace slicefarm::texture::surface_mapping_test
