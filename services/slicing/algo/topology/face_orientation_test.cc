#include "services/slicing/algo/topology/face_orientation.h"

#include <gtest/gtest.h>

#include <vector>

#include "services/slicing/algo/placement/placement.h"
#include "services/slicing/algo/sample_meshes_test.h"
#include "services/slicing/algo/topology/mesh_measure.h"

namespace slicefarm::slicing::face_orientation_test {
namespace {

void Orientation(RawMesh& mesh, size_t face) {
  std::swap(mesh.triangles[face][0], mesh.triangles[face][1]);
}

struct Oriented {
  IndexedMesh mesh;
  EdgeTable table;
  int64_t turned = 0;
};

Oriented Orient(const RawMesh& raw) {
  Oriented result{*PlaceMesh(raw), {}, 0};
  result.table = BuildEdgeTable(result.mesh.triangles, result.mesh.vertices.size());
  result.turned = OrientFaces(result.mesh, result.table);
  return result;
}

void ExpectConsistent(const Oriented& oriented) {
  const EdgeTable fresh = BuildEdgeTable(oriented.mesh.triangles, oriented.mesh.vertices.size());
  EXPECT_EQ(fresh.conflicts, 0);
  EXPECT_EQ(fresh.twins, oriented.table.twins);
}

TEST(OrientFaces, TurnsTheMinority) {
  RawMesh torus = TorusMesh({.around = 16, .sides = 8});
  const double volume = VolumeMm3(*PlaceMesh(torus));
  for (const size_t face : {0, 17, 18, 100, 255}) Orientation(torus, face);
  const Oriented oriented = Orient(torus);
  EXPECT_EQ(oriented.turned, 5);
  EXPECT_DOUBLE_EQ(VolumeMm3(oriented.mesh), volume);
  ExpectConsistent(oriented);
}

TEST(OrientFaces, EachBodyHasItsOwnMajority) {
  RawMesh boxes =
      Joined(BoxMesh({0, 0, 0}, {1, 1, 1}), TurnedInsideOut(BoxMesh({5, 0, 0}, {6, 1, 1})));
  Orientation(boxes, 3);
  Orientation(boxes, 20);
  const Oriented oriented = Orient(boxes);
  EXPECT_EQ(oriented.turned, 2);
  EXPECT_NEAR(VolumeMm3(oriented.mesh), 0, 1e-12);
  ExpectConsistent(oriented);
}

TEST(OrientFaces, OfEqualHalvesTheOneWithVolumeStays) {
  for (const size_t offset : {0, 2}) {
    RawMesh tetrahedron = TetrahedronMesh(6);
    Orientation(tetrahedron, offset);
    Orientation(tetrahedron, offset + 1);
    const Oriented oriented = Orient(tetrahedron);
    EXPECT_EQ(oriented.turned, 2);
    EXPECT_NEAR(VolumeMm3(oriented.mesh), 36, 1e-9);
    ExpectConsistent(oriented);
  }
}

/// Returns a strip of `n` squares with a half twist.
RawMesh MoebiusStrip(int n) {
  RawMesh mesh;
  for (int i = 0; i < n; ++i)
    for (int side = 0; side < 2; ++side)
      mesh.positions.push_back({10.0 * i, 3.0 * side, 1.0 + (i * i) % 7 + side});
  const auto at = [n](int i, int side) {
    return static_cast<uint32_t>(i < n ? 2 * i + side : 2 * (i - n) + (1 - side));
  };
  for (int i = 0; i < n; ++i) {
    mesh.triangles.push_back({at(i, 0), at(i + 1, 0), at(i + 1, 1)});
    mesh.triangles.push_back({at(i, 0), at(i + 1, 1), at(i, 1)});
  }
  return mesh;
}

TEST(OrientFaces, CutsWhatHasOneSideOnly) {
  const Oriented oriented = Orient(MoebiusStrip(9));
  EXPECT_GE(oriented.table.conflicts, 1);
  for (uint32_t h = 0; h < oriented.table.twins.size(); ++h) {
    const uint32_t twin = oriented.table.twins[h];
    if (twin == kNoTwin) continue;
    EXPECT_EQ(OriginOf(oriented.mesh.triangles, h), TargetOf(oriented.mesh.triangles, twin));
  }
}

TEST(OrientFaces, LeavesSoundMeshesAlone) {
  const RawMesh torus = TorusMesh({});
  const Oriented oriented = Orient(torus);
  EXPECT_EQ(oriented.turned, 0);
  EXPECT_EQ(oriented.mesh.triangles, torus.triangles);
}

}  // namespace
}  // namespace slicefarm::slicing::face_orientation_test
