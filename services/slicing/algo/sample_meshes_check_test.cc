#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "services/slicing/algo/mesh_reader/mesh_reader.h"
#include "services/slicing/algo/placement/placement.h"
#include "services/slicing/algo/sample_meshes_test.h"
#include "services/slicing/algo/topology/topology.h"

namespace slicefarm::slicing::sample_meshes_check_test {
namespace {

TEST(SampleMeshes, AreClosedAndTheRightSideOut) {
  for (const RawMesh& raw :
       {BoxMesh({0, 0, 0}, {1, 2, 3}), TetrahedronMesh(5), TorusMesh({}), Mirrored(TorusMesh({})),
        Shuffled(TorusMesh({}), 7), Moved(TetrahedronMesh(5), {1, 2, 3})}) {
    const auto mesh = Connect(*PlaceMesh(raw), {});
    ASSERT_TRUE(mesh.ok());
    EXPECT_TRUE(mesh->closed);
    EXPECT_EQ(mesh->bodies, 1);
    EXPECT_GT(ReportOf(*mesh, {}).volume_mm3, 0);
  }
}

TEST(SampleMeshes, TorusHasItsVolume) {
  const auto mesh = Connect(*PlaceMesh(TorusMesh({.around = 400, .sides = 200})), {});
  const double want = 2 * std::numbers::pi * std::numbers::pi * 30 * 100;
  EXPECT_NEAR(ReportOf(*mesh, {}).volume_mm3, want, want * 1e-3);
}

TEST(SampleMeshes, SnappedTorusLiesOnThePlanes) {
  const RawMesh torus = TorusMesh({.snap_to_layer = 0.2});
  ASSERT_FALSE(torus.positions.empty());
  for (const Vector3& p : torus.positions) {
    const double halves = p.z() / 0.1;
    EXPECT_NEAR(halves, std::round(halves), 1e-9);
    EXPECT_NE(static_cast<int>(std::round(halves)) % 2, 0);
  }
}

TEST(SampleMeshes, FilesSayTheSame) {
  const RawMesh torus = TorusMesh({.around = 8, .sides = 6});
  for (const std::string& bytes : {ToAsciiStl(torus), ToObj(torus)}) {
    const auto read = ReadMesh(bytes, MeshFormat::kUnknown, 1e4, {});
    ASSERT_TRUE(read.ok()) << read.status();
    ASSERT_EQ(read->triangles.size(), torus.triangles.size());
    for (size_t i = 0; i < torus.triangles.size(); ++i)
      for (int k = 0; k < 3; ++k)
        EXPECT_EQ(read->positions[read->triangles[i][k]], torus.positions[torus.triangles[i][k]]);
  }
}

}  // namespace
}  // namespace slicefarm::slicing::sample_meshes_check_test
