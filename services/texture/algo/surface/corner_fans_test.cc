#include "services/texture/algo/surface/corner_fans.h"

#include <gtest/gtest.h>

#include <vector>

#include "services/texture/algo/surface/sample_surfaces_test.h"

namespace slicefarm::texture::corner_fans_test {
namespace {

TEST(CornerFans, AreOneAVertexWithoutASeam) {
  const SurfaceMesh mesh = FlatSquare(2, 1);
  EXPECT_EQ(CornerFans(mesh, {}).sets(), 9);
}

/// The middle is vertex 4. It has two fans if the seam passes through it, and still one if the seam
/// ends there.
TEST(CornerFans, FallApartAlongASeam) {
  const SurfaceMesh mesh = FlatSquare(2, 1);
  const std::vector<SeamEdge> to_middle = {{1, 4}}, across = {{1, 4}, {4, 7}};
  EXPECT_EQ(CornerFans(mesh, to_middle).sets(), 10) << "the boundary's vertex is parted";
  EXPECT_EQ(CornerFans(mesh, across).sets(), 12);
}

TEST(CornerFans, TrianglesThatTouchAtAVertexAreFansOfTheirOwn) {
  SurfaceMesh mesh = FlatSquare(2, 2);
  mesh.triangles = {mesh.triangles[0], mesh.triangles[7]};
  EXPECT_EQ(CornerFans(mesh, {}).sets(), 6);
}

}  // namespace
}  // namespace slicefarm::texture::corner_fans_test
