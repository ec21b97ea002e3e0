#include "services/texture/algo/paths/surface_map.h"

#include <gtest/gtest.h>

#include "services/texture/algo/paths/sample_maps_test.h"

namespace slicefarm::texture::surface_map_test {
namespace {

TEST(SurfaceMap, KnowsNeighboursAndLoops) {
  const SurfaceMap map = MapFromAbove(SquareWithHole(10, 20));
  ASSERT_EQ(map.loops().size(), 2u);
  EXPECT_EQ(map.loops()[0].size(), 40u) << "the outer one first";
  for (size_t t = 0; t < map.mesh().triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int32_t other = map.Neighbour(static_cast<int32_t>(t), k);
      const int32_t from = map.mesh().triangles[t][k];
      if (other < 0) {
        EXPECT_GE(map.InLoop(from).loop, 0);
        continue;
      }
      const auto& corners = map.mesh().triangles[other];
      EXPECT_NE(std::find(corners.begin(), corners.end(), from), corners.end());
    }
  }
  for (size_t l = 0; l < 2; ++l) {
    for (size_t i = 0; i < map.loops()[l].size(); ++i) {
      const int32_t vertex = map.loops()[l][i];
      EXPECT_EQ(map.InLoop(vertex).index, static_cast<int32_t>(i));
      const auto side = map.SideFrom(vertex);
      EXPECT_EQ(map.mesh().triangles[side.triangle][side.corner], vertex);
      EXPECT_EQ(map.Neighbour(side.triangle, side.corner), -1);
    }
  }
}

/// The faces are a roof of 90 degrees; on its ridge the normal is halfway between.
TEST(SurfaceMap, NormalsAreOfFacesEdgesAndVertices) {
  const SurfaceMesh roof = GridSurface(2, [](double x, double y) {
    return Eigen::Vector3d(2 * x, 2 * y, x < 0.6 ? 2 * x : 2 - 2 * x);
  });
  const SurfaceMap map = MapFromAbove(roof);
  const double half = std::sqrt(0.5);
  for (size_t t = 0; t < roof.triangles.size(); ++t) {
    const auto triangle = static_cast<int32_t>(t);
    const SurfacePoint middle{triangle, {0.25, 0.5, 0.25}};
    const double side = map.Position(middle).x() < 1 ? -half : half;
    EXPECT_LT((map.Normal(middle, NormalKind::kFaces) - Eigen::Vector3d(side, 0, half)).norm(),
              1e-12);
    for (int k = 0; k < 3; ++k) {
      SurfacePoint on_edge{triangle, Eigen::Vector3d::Zero()};
      on_edge.weights[k] = 0.3;
      on_edge.weights[(k + 1) % 3] = 0.7;
      const Eigen::Vector3d place = map.Position(on_edge);
      const double x = map.Normal(on_edge, NormalKind::kFaces).x();
      const bool ridge = std::abs(place.x() - 1) < 1e-12;
      EXPECT_NEAR(x, ridge ? 0 : side, 1e-12) << place.transpose();
      SurfacePoint corner{triangle, Eigen::Vector3d::Zero()};
      corner.weights[k] = 1;
      if (std::abs(map.Position(corner).x() - 1) < 1e-12 && map.Position(corner).y() == 1) {
        EXPECT_NEAR(map.Normal(corner, NormalKind::kFaces).x(), 0, 1e-12);
      }
    }
  }
}

TEST(SurfaceMap, NormalsDoNotBreakAtASeam) {
  const SurfaceMap map = FlatMapOf(Sphere(12, 5));
  for (size_t t = 0; t < map.mesh().triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      SurfacePoint on_edge{static_cast<int32_t>(t), Eigen::Vector3d::Zero()};
      on_edge.weights[k] = on_edge.weights[(k + 1) % 3] = 0.5;
      // The mean of two faces of a sphere points to the edge's middle; one face's normal does not.
      const Eigen::Vector3d outwards = map.Position(on_edge).normalized();
      EXPECT_GT(map.Normal(on_edge, NormalKind::kFaces).dot(outwards), 1 - 2e-3);
    }
  }
}

TEST(SurfaceMap, FindsTheNearestPoint) {
  const SurfaceMap map = MapFromAbove(FlatSquare(4, 8));
  const auto near = [&](const Eigen::Vector3d& p) { return map.Position(map.NearestTo(p)); };
  EXPECT_LT((near({3.3, 4.1, 7}) - Eigen::Vector3d(3.3, 4.1, 0)).norm(), 1e-12);
  EXPECT_LT((near({-3, 4.1, 1}) - Eigen::Vector3d(0, 4.1, 0)).norm(), 1e-12);
  EXPECT_LT((near({9, 12, 0}) - Eigen::Vector3d(8, 8, 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace slicefarm::texture::surface_map_test
