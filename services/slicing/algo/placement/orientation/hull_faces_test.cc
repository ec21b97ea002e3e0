#include "services/slicing/algo/placement/orientation/hull_faces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace slicefarm::slicing::hull_faces_test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

double AreaOf(const SpaceHull& hull) {
  double area = 0;
  for (const SpaceHull::Face& face : hull.faces) area += face.area_mm2;
  return area;
}

std::vector<Vertex> RandomCube(std::mt19937& random, size_t count) {
  std::vector<Vertex> points;
  const auto coordinate = [&] { return static_cast<Coord>(random() % 100'000'001); };
  for (size_t i = 0; i < count; ++i) points.push_back({coordinate(), coordinate(), coordinate()});
  for (int i = 0; i < 8; ++i)
    points.push_back({i & 1 ? 100'000'000 : 0, i & 2 ? 100'000'000 : 0, i & 4 ? 100'000'000 : 0});
  return points;
}

TEST(HullOf, AFewPointsInACubeIsTheCube) {
  std::mt19937 random(1);
  const SpaceHull hull = HullOf(RandomCube(random, 100));
  EXPECT_THAT(hull.corners, SizeIs(8));
  EXPECT_THAT(hull.faces, SizeIs(12));
  EXPECT_DOUBLE_EQ(AreaOf(hull), 60'000);
  for (const SpaceHull::Face& face : hull.faces)
    EXPECT_DOUBLE_EQ(face.normal.cwiseAbs().maxCoeff(), 1);
}

TEST(HullOf, ManyPointsInACubeIsTheCube) {
  std::mt19937 random(2);
  const SpaceHull hull = HullOf(RandomCube(random, 200'000));
  EXPECT_DOUBLE_EQ(AreaOf(hull), 60'000);
}

TEST(HullOf, ManyPointsOnABallIsNearlyTheBall) {
  std::mt19937 random(3);
  std::normal_distribution<double> part;
  std::vector<Vertex> points;
  while (points.size() < 200'000) {
    const Eigen::Vector3d d =
        Eigen::Vector3d(part(random), part(random), part(random)).normalized();
    points.push_back({FromMm(50 * d.x()), FromMm(50 * d.y()), FromMm(50 * d.z())});
  }
  const SpaceHull hull = HullOf(points);
  EXPECT_NEAR(AreaOf(hull), 4 * M_PI * 2500, 0.002 * 4 * M_PI * 2500);
  // More points than the limit are 0.02 mm outside, but no point is much farther out.
  for (size_t i = 0; i < points.size(); i += 2'000) {
    const Eigen::Vector3d p(ToMm(points[i].x), ToMm(points[i].y), ToMm(points[i].z));
    double farthest = 0;
    for (const Eigen::Vector3d& corner : hull.corners)
      farthest = std::max(farthest, p.normalized().dot(corner));
    EXPECT_GT(farthest, p.norm() - 0.03);
  }
}

TEST(HullOf, WhatIsFlatHasTwoSides) {
  const std::vector<Vertex> square = {{0, 0, 5}, {9, 0, 5}, {9, 9, 5}, {0, 9, 5}, {4, 4, 5}};
  EXPECT_THAT(HullOf(square).faces, SizeIs(4));
  EXPECT_THAT(HullOf(std::vector<Vertex>{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}).faces, IsEmpty());
  EXPECT_THAT(HullOf(std::vector<Vertex>(5, Vertex{1, 2, 3})).faces, IsEmpty());
  EXPECT_THAT(HullOf({}).corners, IsEmpty());
}

}  // namespace
}  // namespace slicefarm::slicing::hull_faces_test
