#include "services/texture/algo/surface/cut_open.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "services/texture/algo/surface/disk.h"
#include "services/texture/algo/surface/sample_surfaces_test.h"

namespace slicefarm::texture::cut_open_test {
namespace {

struct Case {
  std::string name;
  SurfaceMesh mesh;
  size_t loops = 1;      ///< number after the cut
  double most_seam = 0;  ///< upper limit of the seam's length in mm
};

SurfaceMesh TorusWithHole() {
  SurfaceMesh torus = Torus(24, 12, 10, 3);
  torus.triangles.erase(torus.triangles.begin() + 100);
  return torus;
}

std::vector<Case> Cases() {
  return {
      {"disk", FlatSquare(6, 1), 1, 0},
      {"sphere", Sphere(12, 5), 1, 5 * 3.3 * 2},
      {"torus", Torus(24, 12, 10, 3), 1, 2 * 3.1416 * (3 + 10)},
      {"torus with a hole", TorusWithHole(), 2, 2 * 3.1416 * (3 + 10)},
      {"torus with two handles", DoubleTorus(), 1, 60},
  };
}

double SeamLength(const SurfaceMesh& mesh, const std::vector<SeamEdge>& seam) {
  double length = 0;
  for (const auto& [a, b] : seam) length += (mesh.points_mm[a] - mesh.points_mm[b]).norm();
  return length;
}

TEST(CutOpen, MakesADiskOfAnySurfaceAlongAShortSeam) {
  for (const Case& c : Cases()) {
    SCOPED_TRACE(c.name);
    const auto topology = TopologyOf(c.mesh);
    ASSERT_TRUE(topology.ok()) << topology.status();
    const std::vector<SeamEdge> seam = SeamOf(c.mesh, *topology);
    const OpenedSurface opened = CutOpen(c.mesh, seam);
    const auto loops = BoundaryOfDisk(opened.mesh);
    ASSERT_TRUE(loops.ok()) << loops.status();
    EXPECT_EQ(loops->size(), c.loops);
    EXPECT_LE(SeamLength(c.mesh, seam), c.most_seam);
    ASSERT_EQ(opened.mesh.triangles.size(), c.mesh.triangles.size());
    for (size_t t = 0; t < c.mesh.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const int32_t vertex = opened.mesh.triangles[t][k];
        EXPECT_EQ(opened.vertex_of[vertex], c.mesh.triangles[t][k]);
        EXPECT_EQ(opened.mesh.points_mm[vertex], c.mesh.points_mm[c.mesh.triangles[t][k]]);
      }
    }
  }
}

TEST(CutOpen, WithoutASeamNothingChanges) {
  const SurfaceMesh mesh = Torus(8, 6, 10, 3);
  const OpenedSurface opened = CutOpen(mesh, {});
  EXPECT_EQ(opened.mesh.triangles, mesh.triangles);
  EXPECT_EQ(opened.mesh.points_mm.size(), mesh.points_mm.size());
}

}  // namespace
}  // namespace slicefarm::texture::cut_open_test
