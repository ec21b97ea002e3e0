#include "services/slicing/algo/placement/surfaces.h"

#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::slicing::surfaces_test {
namespace {

SliceInput Given() {
  SliceInput input;
  input.files = {
      {"s", MeshFormat::kObj, "v 0.1 0 0\nv 1e-12 1 0\nv 0 0 1\nv 0.1 0 0\nf 1 2 3\nf 4 3 2\n"}};
  input.objects = {{.name = "s", .parts = {{}}, .ranges = {}}};
  input.objects[0].parts[0].mesh.mesh = kOnlyMesh;
  return input;
}

TEST(SurfacesOf, KeepsTheFilesNumbers) {
  const auto surfaces = SurfacesOf(Given(), *MakeDirectMeshSource(), {});
  ASSERT_TRUE(surfaces.ok()) << surfaces.status();
  ASSERT_EQ(surfaces->size(), 1u);
  const SurfaceMesh& mesh = surfaces->front();
  ASSERT_EQ(mesh.points_mm.size(), 4u) << "points at one place stay apart";
  EXPECT_EQ(mesh.points_mm[1], Eigen::Vector3d(1e-12, 1, 0));
  EXPECT_EQ(mesh.triangles[1], (std::array<int32_t, 3>{3, 2, 1}));
}

TEST(SurfacesOf, HeedsTheScale) {
  SliceInput input = Given();
  input.objects[0].to_plate *= 2;
  const auto surfaces = SurfacesOf(std::move(input), *MakeDirectMeshSource(), {});
  ASSERT_TRUE(surfaces.ok()) << surfaces.status();
  EXPECT_EQ(surfaces->front().points_mm[0], Eigen::Vector3d(0.2, 0, 0));
}

TEST(SurfacesOf, RefusesWhatIsFarFromTheOrigin) {
  SliceInput input = Given();
  input.objects[0].to_plate *= 1e6;
  const auto surfaces = SurfacesOf(std::move(input), *MakeDirectMeshSource(), {});
  EXPECT_EQ(DetailOf(surfaces.status()).reason, Reason::kMeshTooLarge);
}

TEST(SurfacesOf, RefusesCopies) {
  SliceInput input = Given();
  input.objects[0].copies.resize(2);
  const auto surfaces = SurfacesOf(std::move(input), *MakeDirectMeshSource(), {});
  EXPECT_EQ(DetailOf(surfaces.status()).reason, Reason::kRequestMalformed);
}

}  // namespace
}  // namespace slicefarm::slicing::surfaces_test
