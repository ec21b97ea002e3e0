#include "services/milling/algo/mesh/triangle_mesh.h"

#include <gtest/gtest.h>

#include "services/milling/algo/sample_parts_test.h"

namespace slicefarm::milling::triangle_mesh_test {
namespace {

TEST(EdgesOf, HasEachEdgeOnce) {
  const TriangleMesh box = Box({0, 0, 0}, {1, 2, 3});
  const MeshEdges edges = EdgesOf(box);
  EXPECT_EQ(edges.ends.size(),
            17u);  // a box of 12 triangles has 18 edges; the bottom's diagonal is missing
  for (size_t t = 0; t < box.triangles.size(); ++t) {
    for (size_t k = 0; k < 3; ++k) {
      const auto& ends = edges.ends[edges.of_triangle[t][k]];
      const uint32_t a = box.triangles[t][k], b = box.triangles[t][(k + 1) % 3];
      EXPECT_TRUE((ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a));
    }
  }
}

TEST(EdgesOf, TakesTrianglesWithoutArea) {
  TriangleMesh mesh;
  mesh.points_mm = {{0, 0, 0}, {1, 0, 0}};
  mesh.triangles = {{0, 0, 0}, {0, 1, 1}, {1, 0, 0}};
  EXPECT_EQ(EdgesOf(mesh).ends.size(), 3u);
  EXPECT_TRUE(EdgesOf({}).ends.empty());
}

}  // namespace
}  // namespace slicefarm::milling::triangle_mesh_test
