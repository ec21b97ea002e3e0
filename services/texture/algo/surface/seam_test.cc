#include "services/texture/algo/surface/seam.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "services/texture/algo/surface/sample_surfaces_test.h"

namespace slicefarm::texture::seam_test {
namespace {

std::map<int32_t, int> DegreesOf(const std::vector<SeamEdge>& seam) {
  std::map<int32_t, int> degrees;
  for (const SeamEdge& edge : seam) {
    for (const int32_t vertex : edge) ++degrees[vertex];
  }
  return degrees;
}

TEST(SeamOf, ADiskNeedsNone) {
  const SurfaceMesh mesh = FlatSquare(3, 1);
  EXPECT_THAT(SeamOf(mesh, *TopologyOf(mesh)), testing::IsEmpty());
}

TEST(SeamOf, AroundHandlesNothingEndsBlindly) {
  for (const SurfaceMesh& mesh : {Torus(24, 12, 10, 3), DoubleTorus()}) {
    const std::vector<SeamEdge> seam = SeamOf(mesh, *TopologyOf(mesh));
    EXPECT_TRUE(std::is_sorted(seam.begin(), seam.end()));
    for (const auto& [vertex, degree] : DegreesOf(seam)) EXPECT_GE(degree, 2) << vertex;
  }
}

/// A long body is cut from end to end.
TEST(SeamOf, ASphereIsCutBetweenFarPlaces) {
  SurfaceMesh mesh = Sphere(12, 1);
  for (Eigen::Vector3d& p : mesh.points_mm) p.x() *= 20;
  const std::vector<SeamEdge> seam = SeamOf(mesh, *TopologyOf(mesh));
  double low = 0, high = 0;
  for (const auto& [vertex, degree] : DegreesOf(seam)) {
    low = std::min(low, mesh.points_mm[vertex].x());
    high = std::max(high, mesh.points_mm[vertex].x());
  }
  EXPECT_LT(low, -19);
  EXPECT_GT(high, 19);
}

}  // namespace
}  // namespace slicefarm::texture::seam_test
