#include "services/texture/algo/output/displaced_mesh.h"

#include <gtest/gtest.h>

#include <map>

#include "common/base/error.h"
#include "services/texture/algo/paths/sample_maps_test.h"
#include "services/texture/algo/pattern/computed_heights.h"

namespace slicefarm::texture::displaced_mesh_test {
namespace {

EngravePlan PlanOn(const SurfaceMesh& mesh, bool engraved = false) {
  return *PlanEngraving(FlatMapOf(mesh),
                        *TextureOf(*ComputedHeights(*ParseTextureSpec("bumps:height=0.3,pitch=2"))),
                        std::nullopt, {.engraved = engraved});
}

double VolumeOf(const SurfaceMesh& mesh) {
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    volume += mesh.points_mm[a].cross(mesh.points_mm[b]).dot(mesh.points_mm[c]) / 6;
  return volume;
}

/// Returns the number of sides without a matching side in the other direction between the same
/// positions.
int64_t OpenSides(const SurfaceMesh& mesh) {
  using Position = std::array<double, 3>;
  std::map<std::pair<Position, Position>, int> sides;
  const auto place = [&](int32_t v) {
    const Eigen::Vector3d& p = mesh.points_mm[v];
    return Position{p.x(), p.y(), p.z()};
  };
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++sides[{place(t[k]), place(t[(k + 1) % 3])}];
  int64_t open = 0;
  for (const auto& [side, count] : sides) {
    const auto back = sides.find({side.second, side.first});
    open += back == sides.end() || back->second != count;
  }
  return open;
}

TEST(DisplacedMesh, AClosedSurfaceStaysClosedAndGrowsByTheTexture) {
  const SurfaceMesh sphere = Sphere(10, 6);
  const auto raised = DisplacedMesh(PlanOn(sphere), {.edge_mm = 0.3});
  const auto engraved = DisplacedMesh(PlanOn(sphere, true), {.edge_mm = 0.3});
  ASSERT_TRUE(raised.ok() && engraved.ok());
  EXPECT_EQ(OpenSides(*raised), 0);
  EXPECT_EQ(OpenSides(*engraved), 0);
  EXPECT_GT(VolumeOf(*raised), 1.01 * VolumeOf(sphere));
  EXPECT_LT(VolumeOf(*engraved), 0.99 * VolumeOf(sphere));
  for (const auto& t : raised->triangles)
    for (int k = 0; k < 3; ++k)
      EXPECT_LT((raised->points_mm[t[k]] - raised->points_mm[t[(k + 1) % 3]]).norm(), 0.3 + 0.31);
}

TEST(DisplacedMesh, IsAsHighAsTheTexture) {
  const EngravePlan plan = PlanOn(FlatSquare(3, 9));
  const auto mesh = DisplacedMesh(plan, {.edge_mm = 0.1});
  ASSERT_TRUE(mesh.ok());
  double highest = 0;
  for (const Eigen::Vector3d& p : mesh->points_mm) {
    highest = std::max(highest, p.z());
    EXPECT_GE(p.z(), 0);
  }
  EXPECT_NEAR(highest, 0.3, 0.01);
}

TEST(DisplacedMesh, RefusesTooManyTriangles) {
  const auto mesh = DisplacedMesh(PlanOn(FlatSquare(1, 4000)), {.edge_mm = 0.001});
  EXPECT_EQ(DetailOf(mesh.status()).reason, Reason::kRequestTooLarge);
}

TEST(DisplacedMesh, IsWrittenAsStlAndObj) {
  const SurfaceMesh square = FlatSquare(1, 2);
  EXPECT_EQ(StlBytes(square).size(), 84u + 2 * 50);
  EXPECT_EQ(ObjText(square), "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 2 2 0\nf 1 2 4\nf 1 4 3\n");
}

}  // namespace
}  // namespace slicefarm::texture::displaced_mesh_test
