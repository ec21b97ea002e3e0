#include "services/texture/algo/map/tutte.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "services/texture/algo/map/exact_turn.h"
#include "services/texture/algo/surface/sample_surfaces_test.h"

namespace slicefarm::texture::tutte_test {
namespace {

SurfaceMesh SquareWithHoles() {
  return Without(FlatSquare(20, 10), [](const Eigen::Vector3d& p) {
    return std::hypot(p.x() - 3, p.y() - 3) < 1 || std::hypot(p.x() - 7, p.y() - 6) < 2;
  });
}

TEST(TutteEmbedding, NothingFlipsAndTheBoundaryIsACircleOfTheSurfacesArea) {
  for (const SurfaceMesh& mesh : {FlatSquare(9, 10), Cap(24, -0.99), SquareWithHoles()}) {
    const auto loops = BoundaryOfDisk(mesh);
    ASSERT_TRUE(loops.ok()) << loops.status();
    const auto map = TutteEmbedding(mesh, *loops);
    ASSERT_TRUE(map.ok()) << map.status();
    double area = 0;
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      EXPECT_EQ(ExactTurn(map->points[a], map->points[b], map->points[c]), 1) << t;
      area += DoubleAreaVector(mesh, t).norm() / 2;
    }
    for (const int32_t vertex : loops->front())
      EXPECT_NEAR(map->points[vertex].squaredNorm() * std::numbers::pi, area, 1e-9 * area);
  }
}

TEST(TutteEmbedding, AHolesMiddleSeesAllOfItsEdges) {
  const SurfaceMesh mesh = SquareWithHoles();
  const auto loops = BoundaryOfDisk(mesh);
  const auto map = TutteEmbedding(mesh, *loops);
  ASSERT_EQ(map->hole_middles.size(), 2U);
  for (size_t hole = 1; hole < loops->size(); ++hole) {
    const BoundaryLoop& loop = (*loops)[hole];
    for (size_t i = 0; i < loop.size(); ++i)
      EXPECT_EQ(ExactTurn(map->points[loop[(i + 1) % loop.size()]], map->points[loop[i]],
                          map->hole_middles[hole - 1]),
                1);
  }
}

}  // namespace
}  // namespace slicefarm::texture::tutte_test
