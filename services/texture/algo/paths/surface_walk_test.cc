#include "services/texture/algo/paths/surface_walk.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "services/texture/algo/paths/sample_maps_test.h"

namespace slicefarm::texture::surface_walk_test {
namespace {

bool ShareATriangle(const SurfaceMap& map, const SurfacePoint& a, const SurfacePoint& b) {
  // These are the vertices with a weight in either point; all of them must belong to one triangle.
  std::vector<int32_t> vertices;
  for (const SurfacePoint& p : {a, b})
    for (int k = 0; k < 3; ++k)
      if (p.weights[k] != 0) vertices.push_back(map.mesh().triangles[p.triangle][k]);
  return std::any_of(map.mesh().triangles.begin(), map.mesh().triangles.end(),
                     [&](const auto& corners) {
                       return std::all_of(vertices.begin(), vertices.end(), [&](int32_t v) {
                         return std::find(corners.begin(), corners.end(), v) != corners.end();
                       });
                     });
}

double LengthOf(const SurfaceMap& map, const SurfacePoint& from, const SurfaceWalk& walk,
                const SurfacePoint& to) {
  std::vector<SurfacePoint> points = {from};
  points.insert(points.end(), walk.between.begin(), walk.between.end());
  points.push_back(to);
  double length = 0;
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    EXPECT_TRUE(ShareATriangle(map, points[i], points[i + 1])) << "step " << i;
    length += (map.MapPosition(points[i + 1]) - map.MapPosition(points[i])).norm();
  }
  return length;
}

TEST(WalkBetween, IsStraight) {
  const SurfaceMap map = MapFromAbove(FlatSquare(9, 9));
  for (int i = 0; i < 40; ++i) {
    const SurfacePoint from{i * 4, {0.2, 0.3, 0.5}}, to{161 - i * 3, {0.6, 0.3, 0.1}};
    const auto walk = WalkBetween(map, from, to);
    ASSERT_TRUE(walk.has_value());
    EXPECT_TRUE(walk->straight);
    EXPECT_NEAR(LengthOf(map, from, *walk, to),
                (map.MapPosition(to) - map.MapPosition(from)).norm(), 1e-5);
  }
}

TEST(WalkBetween, BeginsAndEndsOnEdgesAndVertices) {
  const SurfaceMap map = MapFromAbove(FlatSquare(5, 5));
  const Eigen::Vector3d ends[] = {
      {1, 0, 0}, {0, 1, 0}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}};
  for (int from_triangle = 0; from_triangle < 50; from_triangle += 7) {
    for (int to_triangle = 1; to_triangle < 50; to_triangle += 5) {
      for (const auto& a : ends) {
        for (const auto& b : ends) {
          const SurfacePoint from{from_triangle, a}, to{to_triangle, b};
          const auto walk = WalkBetween(map, from, to);
          ASSERT_TRUE(walk.has_value());
          EXPECT_NEAR(LengthOf(map, from, *walk, to),
                      (map.MapPosition(to) - map.MapPosition(from)).norm(), 1e-5);
        }
      }
    }
  }
}

TEST(WalkBetween, GoesAroundAHole) {
  const SurfaceMap map = MapFromAbove(SquareWithHole(10, 10));  // from 3 to 7
  const SurfacePoint from = map.NearestTo({1, 4.1, 0}), to = map.NearestTo({9, 4.2, 0});
  const auto walk = WalkBetween(map, from, to);
  ASSERT_TRUE(walk.has_value());
  EXPECT_FALSE(walk->straight);
  EXPECT_NEAR(LengthOf(map, from, *walk, to), 2 + 1.15 + 4 + 1.15 + 2, 0.1) << "below it";
}

TEST(WalkBetween, GoesAroundABay) {
  const SurfaceMap map = MapFromAbove(Without(FlatSquare(10, 10), [](const Eigen::Vector3d& p) {
    return p.x() > 4 && p.x() < 6 && p.y() > 3;
  }));
  const SurfacePoint from = map.NearestTo({2, 8.1, 0}), to = map.NearestTo({8, 8.2, 0});
  const auto walk = WalkBetween(map, from, to);
  ASSERT_TRUE(walk.has_value());
  EXPECT_FALSE(walk->straight);
  EXPECT_NEAR(LengthOf(map, from, *walk, to), 2 + 5.15 + 2 + 5.15 + 2, 0.1);
}

}  // namespace
}  // namespace slicefarm::texture::surface_walk_test
