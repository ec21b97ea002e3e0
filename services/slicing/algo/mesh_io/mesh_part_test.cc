#include "services/slicing/algo/mesh_io/mesh_part.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::slicing::mesh_part_test {
namespace {

using testing::ElementsAre;

/// Returns a strip of three triangles over six corners.
RawMesh Strip() {
  RawMesh mesh;
  for (int i = 0; i < 6; ++i) mesh.positions.push_back({1.0 * i, 0, 0});
  mesh.triangles = {{0, 1, 2}, {5, 3, 2}, {4, 5, 3}};
  return mesh;
}

MeshRef Triangles(int64_t first, int64_t count) {
  return {.first_triangle = first, .triangle_count = count};
}

TEST(MeshPart, TheWholeMesh) {
  for (const MeshRef& ref : {MeshRef{}, Triangles(0, 3)}) {
    const auto part = MeshPart(Strip(), ref);
    ASSERT_TRUE(part.ok()) << part.status();
    EXPECT_EQ(part->positions, Strip().positions);
    EXPECT_EQ(part->triangles, Strip().triangles);
  }
}

TEST(MeshPart, ARangeKeepsItsOwnCornersInOrder) {
  const auto part = MeshPart(Strip(), Triangles(1, 1));
  ASSERT_TRUE(part.ok()) << part.status();
  EXPECT_THAT(part->positions, ElementsAre(Vector3{2, 0, 0}, Vector3{3, 0, 0}, Vector3{5, 0, 0}));
  EXPECT_THAT(part->triangles, ElementsAre(std::array<uint32_t, 3>{2, 1, 0}));
}

TEST(MeshPart, ToTheEnd) {
  const auto part = MeshPart(Strip(), Triangles(1, -1));
  ASSERT_TRUE(part.ok()) << part.status();
  EXPECT_EQ(part->triangles.size(), 2u);
  EXPECT_EQ(part->positions.size(), 4u);
}

TEST(MeshPart, NoTriangleIsNoPart) {
  EXPECT_EQ(DetailOf(MeshPart(Strip(), Triangles(1, 0)).status()).reason, Reason::kMeshEmpty);
  EXPECT_EQ(DetailOf(MeshPart(Strip(), Triangles(3, -1)).status()).reason, Reason::kMeshEmpty);
  EXPECT_EQ(DetailOf(MeshPart({}, {}).status()).reason, Reason::kMeshEmpty);
}

TEST(MeshPart, TrianglesThatAreNotThere) {
  for (const MeshRef& ref : {Triangles(-1, 1), Triangles(0, 4), Triangles(2, 2), Triangles(4, -1),
                             Triangles(0, -2), Triangles(1, INT64_MAX), Triangles(INT64_MAX, 1)})
    EXPECT_EQ(DetailOf(MeshPart(Strip(), ref).status()).reason, Reason::kRequestMalformed)
        << ref.first_triangle << " " << ref.triangle_count;
}

}  // namespace
}  // namespace slicefarm::slicing::mesh_part_test
