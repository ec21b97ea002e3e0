#include "services/slicing/algo/topology/mesh_measure.h"

#include <gtest/gtest.h>

#include "common/model/limits.h"
#include "services/slicing/algo/placement/placement.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing::mesh_measure_test {
namespace {

IndexedMesh Placed(const RawMesh& raw) { return *PlaceMesh(raw); }

TEST(VolumeMm3, OfKnownShapes) {
  EXPECT_DOUBLE_EQ(VolumeMm3(Placed(BoxMesh({1, 2, 3}, {11, 22, 33}))), 6000);
  EXPECT_NEAR(VolumeMm3(Placed(TetrahedronMesh(6))), 36, 1e-9);
  EXPECT_DOUBLE_EQ(VolumeMm3(Placed(TurnedInsideOut(BoxMesh({0, 0, 0}, {1, 1, 1})))), -1);
}

TEST(VolumeMm3, DoesNotDependOnTheOrder) {
  const RawMesh torus = TorusMesh({});
  EXPECT_EQ(VolumeMm3(Placed(torus)), VolumeMm3(Placed(Shuffled(torus, 1))));
}

TEST(HasNoArea, IsExactAtTheLimits) {
  constexpr Coord kFar = limits::kMaxCoord;
  IndexedMesh mesh;
  mesh.vertices = {{-kFar, -kFar, 0}, {kFar, kFar, 0}, {0, 0, 0},
                   {0, 1, 0},         {0, 0, 1},       {-1, -1, 0}};
  EXPECT_TRUE(HasNoArea(mesh, {0, 1, 2}));
  EXPECT_TRUE(HasNoArea(mesh, {5, 1, 2}));
  EXPECT_FALSE(HasNoArea(mesh, {0, 1, 3}));
  EXPECT_FALSE(HasNoArea(mesh, {0, 1, 4}));
  EXPECT_FALSE(HasNoArea(mesh, {2, 3, 4}));
  EXPECT_TRUE(HasNoArea(mesh, {2, 2, 4}));
}

}  // namespace
}  // namespace slicefarm::slicing::mesh_measure_test
