#include "services/slicing/algo/placement/arranging/footprint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/convex.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::slicing::footprint_test {
namespace {

Polygon HullOf(const IndexedMesh& mesh) {
  const IndexedMesh* const meshes[] = {&mesh};
  return Footprint(meshes);
}

using testing::ElementsAre;

Point At(double x_mm, double y_mm) { return {FromMm(x_mm), FromMm(y_mm)}; }

const Polygon kSquare = MakePolygonsOrDie("(-5 -5, 5 -5, 5 5, -5 5)")[0].outer;
const Polygon kDiamond = MakePolygonsOrDie("(-5 0, 0 -5, 5 0, 0 5)")[0].outer;

TEST(Footprint, IsTheHullOfAllCorners) {
  uint64_t seed = 1;
  const auto next = [&seed](Coord range) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return static_cast<Coord>((seed >> 33) % static_cast<uint64_t>(2 * range + 1)) - range;
  };
  for (const Coord range : {Coord{2}, Coord{9}, Coord{1'000}, Coord{100'000'000}}) {
    for (int round = 0; round < 200; ++round) {
      IndexedMesh mesh;
      std::vector<Point> points;
      for (int i = 0; i < 1 + round % 60; ++i) {
        mesh.vertices.push_back({next(range), next(range), next(range)});
        points.push_back({mesh.vertices.back().x, mesh.vertices.back().y});
      }
      ASSERT_EQ(HullOf(mesh), ConvexHull(points)) << range << " " << round;
    }
  }
}

TEST(Footprint, OfSeveralMeshesAndOfNone) {
  const IndexedMesh left = {{{0, 0, 0}, {0, 10, 5}, {5, 5, 9}}, {}};
  const IndexedMesh right = {{{20, 0, 0}, {20, 10, 5}}, {}};
  const IndexedMesh* const meshes[] = {&left, &right};
  EXPECT_EQ(Footprint(meshes), (Polygon{{0, 0}, {20, 0}, {20, 10}, {0, 10}}));
  EXPECT_TRUE(Footprint({}).empty());
  EXPECT_TRUE(HullOf({}).empty());
}

using Pairs = std::vector<std::pair<CopyOf, CopyOf>>;

TEST(OverlappingFootprints, OfCopiesThatStandOnOthers) {
  const std::vector<Point> row = {At(0, 0), At(29, 9), At(20, 0), At(60, 0)};
  EXPECT_EQ(OverlappingFootprints(std::vector<Copies>{{&kSquare, row}}), (Pairs{{{0, 1}, {0, 2}}}));
}

TEST(OverlappingFootprints, TouchingIsNotOverlapping) {
  const std::vector<Point> grid = {At(0, 0), At(10, 0), At(0, 10), At(10, 10)};
  EXPECT_TRUE(OverlappingFootprints(std::vector<Copies>{{&kSquare, grid}}).empty());
}

TEST(OverlappingFootprints, AreHullsAndNotBoxes) {
  const std::vector<Point> corner = {At(0, 0), At(6, 6)};
  EXPECT_TRUE(OverlappingFootprints(std::vector<Copies>{{&kDiamond, corner}}).empty());
  EXPECT_EQ(OverlappingFootprints(std::vector<Copies>{{&kSquare, corner}}).size(), 1u);
}

TEST(OverlappingFootprints, OfSeveralParts) {
  const std::vector<Point> squares = {At(50, 0), At(0, 0)}, diamonds = {At(3, 1), At(3, 0)};
  const Polygon line = {At(0, 0), At(9, 0)};
  EXPECT_EQ(OverlappingFootprints(
                std::vector<Copies>{{&kSquare, squares}, {&line, squares}, {&kDiamond, diamonds}}),
            (Pairs{{{0, 1}, {2, 0}}, {{0, 1}, {2, 1}}, {{2, 0}, {2, 1}}}));
}

}  // namespace
}  // namespace slicefarm::slicing::footprint_test
