#include "services/slicing/algo/topology/topology.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/base/error.h"
#include "services/slicing/algo/placement/placement.h"
#include "services/slicing/algo/sample_meshes_test.h"
#include "services/slicing/algo/topology/mesh_measure.h"

namespace slicefarm::slicing::topology_test {
namespace {

RawMesh WithFlippedFace(RawMesh mesh, size_t face) {
  std::swap(mesh.triangles[face][0], mesh.triangles[face][1]);
  return mesh;
}

RawMesh WithFace(RawMesh mesh, const Triangle& face) {
  mesh.triangles.push_back(face);
  return mesh;
}

/// Returns the same face, beginning at another corner.
Triangle Turned(const Triangle& face) { return {face[1], face[2], face[0]}; }

struct Case {
  std::string name;
  RawMesh mesh;
  int64_t bodies, open, non_manifold, flipped, degenerate, repeated;
  bool closed;
};

TEST(Connect, ReportsWhatTheMeshIsLike) {
  const std::vector<Case> cases = {
      {"Cube", Cube(0, 0, 0), 1, 0, 0, 0, 0, 0, true},
      {"Torus", TorusMesh({}), 1, 0, 0, 0, 0, 0, true},
      {"OpenCube", WithoutTriangle(Cube(0, 0, 0), 5), 1, 3, 0, 0, 0, 0, true},
      {"TwoCubes", Joined(Cube(0, 0, 0), Cube(20, 0, 0)), 2, 0, 0, 0, 0, 0, true},
      {"TouchingInACorner", Joined(Cube(0, 0, 0), Cube(10, 10, 10)), 2, 0, 0, 0, 0, 0, true},
      {"TouchingInAnEdge", Joined(Cube(0, 0, 0), Cube(10, 10, 0)), 1, 0, 1, 0, 0, 0, true},
      {"TheSameCubeTwice", Joined(Cube(0, 0, 0), Cube(0, 0, 0)), 1, 0, 0, 0, 0, 12, true},
      {"FlippedFace", WithFlippedFace(Cube(0, 0, 0), 7), 1, 0, 0, 1, 0, 0, true},
      {"InsideOut", TurnedInsideOut(Cube(0, 0, 0)), 1, 0, 0, 0, 0, 0, true},
      {"CollapsedFace", WithFace(Cube(0, 0, 0), {1, 1, 5}), 1, 0, 0, 0, 1, 0, true},
      {"AFaceTwice", WithFace(Cube(0, 0, 0), Turned(Cube(0, 0, 0).triangles[4])), 1, 0, 0, 0, 0, 1,
       true},
      {"AFaceThreeTimes",
       WithFace(WithFace(Cube(0, 0, 0), Cube(0, 0, 0).triangles[9]), Cube(0, 0, 0).triangles[9]), 1,
       0, 0, 0, 0, 2, true},
      {"OneFaceTwice", RawMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}, {{0, 1, 2}, {2, 0, 1}}}, 1, 3, 0,
       0, 0, 1, false},
      {"BackToBack", RawMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}, {{0, 1, 2}, {2, 1, 0}}}, 1, 0, 0, 0,
       0, 0, true},
      {"ExtraFace", WithFace(Cube(0, 0, 0), {0, 1, 7}), 1, 2, 1, 0, 0, 0, false},
  };
  for (const Case& c : cases) {
    const auto mesh = Connect(*PlaceMesh(c.mesh), {});
    ASSERT_TRUE(mesh.ok()) << c.name;
    EXPECT_EQ(mesh->triangles, static_cast<int64_t>(c.mesh.triangles.size())) << c.name;
    EXPECT_EQ(mesh->bodies, c.bodies) << c.name;
    EXPECT_EQ(mesh->open_edges, c.open) << c.name;
    EXPECT_EQ(mesh->non_manifold_edges, c.non_manifold) << c.name;
    EXPECT_EQ(mesh->flipped_faces, c.flipped) << c.name;
    EXPECT_EQ(mesh->degenerate_faces, c.degenerate) << c.name;
    EXPECT_EQ(mesh->repeated_faces, c.repeated) << c.name;
    EXPECT_EQ(mesh->closed, c.closed) << c.name;
  }
}

TEST(Connect, PutsInAFaceThatIsMissing) {
  for (size_t face = 0; face < 12; ++face) {
    RawMesh mesh = Cube(0, 0, 0);
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<ptrdiff_t>(face));
    const auto connected = Connect(*PlaceMesh(mesh), {});
    ASSERT_TRUE(connected.ok());
    EXPECT_TRUE(connected->closed) << face;
    EXPECT_EQ(connected->open_edges, 3) << "as the file had it";
    EXPECT_EQ(connected->mesh.triangles.size(), 12u);
    EXPECT_DOUBLE_EQ(VolumeMm3(connected->mesh), 1000) << face;
  }
}

TEST(Connect, LeavesOtherOpeningsAsTheyAre) {
  RawMesh side = Cube(0, 0, 0);
  side.triangles.resize(10);
  for (const RawMesh& mesh : {side, RawMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}, {{0, 1, 2}}}}) {
    const auto connected = Connect(*PlaceMesh(mesh), {});
    ASSERT_TRUE(connected.ok());
    EXPECT_EQ(connected->mesh.triangles.size(), mesh.triangles.size());
    EXPECT_FALSE(connected->closed);
  }
}

/// A vertex of the neighbours is on an edge of the face; a face without area closes the gap.
TEST(Connect, KeepsFacesWithoutAreaThatJoinTheirNeighbours) {
  RawMesh mesh = TetrahedronMesh(10);
  mesh.positions.push_back({5, 0, 0});
  mesh.triangles = {{0, 2, 4}, {4, 2, 1}, {0, 1, 3}, {0, 4, 1}, {0, 3, 2}, {1, 2, 3}};
  const auto connected = Connect(*PlaceMesh(mesh), {});
  ASSERT_TRUE(connected.ok());
  EXPECT_EQ(connected->degenerate_faces, 1);
  EXPECT_TRUE(connected->closed);
  EXPECT_EQ(connected->mesh.triangles.size(), 6u);
}

TEST(Connect, RefusesAMeshOfDegenerateFacesOnly) {
  const RawMesh mesh = {{{0, 0, 0}, {1e-9, 0, 0}, {0, 1e-9, 0}}, {{0, 1, 2}}};
  const auto connected = Connect(*PlaceMesh(mesh), {});
  EXPECT_EQ(DetailOf(connected.status()).reason, Reason::kMeshEmpty);
}

TEST(Connect, CanBeCancelled) {
  const auto connected = Connect(*PlaceMesh(TorusMesh({})), CancelToken([] { return true; }));
  EXPECT_EQ(connected.status().code(), absl::StatusCode::kCancelled);
}

TEST(ReportOf, TellsWhereTheFirstCopyStands) {
  const auto connected = Connect(*PlaceMesh(Cube(3, 4, 5)), {});
  const MeshReport report = ReportOf(*connected, {100 * kNmPerMm, 50 * kNmPerMm});
  EXPECT_EQ(report.triangles, 12);
  EXPECT_EQ(report.vertices, 8);
  EXPECT_DOUBLE_EQ(report.volume_mm3, 1000);
  EXPECT_EQ(report.min_mm, (std::array<double, 3>{95, 45, 0}));
  EXPECT_EQ(report.max_mm, (std::array<double, 3>{105, 55, 10}));
}

TEST(CountEdges, PassesOverCollapsedFaces) {
  const EdgeCounts counts = CountEdges({{0, 1, 2}, {1, 1, 2}}, 3);
  EXPECT_EQ(counts.open, 3);
  EXPECT_EQ(counts.non_manifold, 0);
}

}  // namespace
}  // namespace slicefarm::slicing::topology_test
