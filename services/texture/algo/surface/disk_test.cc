#include "services/texture/algo/surface/disk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "common/base/error.h"
#include "services/texture/algo/surface/sample_surfaces_test.h"

namespace slicefarm::texture::disk_test {
namespace {

TEST(BoundaryOfDisk, GoesRoundWithTheSurfaceOnTheLeft) {
  const auto loops = BoundaryOfDisk(FlatSquare(1, 1));
  ASSERT_TRUE(loops.ok()) << loops.status();
  EXPECT_THAT(*loops, testing::ElementsAre(testing::ElementsAre(0, 1, 3, 2)));
}

TEST(BoundaryOfDisk, TheLongestLoopComesFirstAndHolesFollow) {
  const SurfaceMesh mesh = Without(FlatSquare(10, 10), [](const Eigen::Vector3d& p) {
    return (std::abs(p.x() - 2.5) < 0.5 || std::abs(p.x() - 7.5) < 0.5) &&
           std::abs(p.y() - 4.5) < 0.5;
  });
  const auto loops = BoundaryOfDisk(mesh);
  ASSERT_TRUE(loops.ok()) << loops.status();
  EXPECT_THAT(*loops,
              testing::ElementsAre(testing::SizeIs(40), testing::SizeIs(4), testing::SizeIs(4)));
}

SurfaceMesh Tetrahedron() {
  return {.points_mm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          .triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

SurfaceMesh TorusWithAHole() {
  SurfaceMesh mesh = Torus(8, 8, 3, 1);
  mesh.triangles.pop_back();
  return mesh;
}

TEST(TopologyOf, CountsHandlesAndLoops) {
  const struct {
    SurfaceMesh mesh;
    int64_t handles = 0;
    size_t loops = 0;
  } cases[] = {{FlatSquare(3, 1), 0, 1},
               {Sphere(4, 1), 0, 0},
               {Torus(8, 6, 3, 1), 1, 0},
               {TorusWithAHole(), 1, 1},
               {DoubleTorus(), 2, 0}};
  for (const auto& c : cases) {
    const auto topology = TopologyOf(c.mesh);
    ASSERT_TRUE(topology.ok()) << topology.status();
    EXPECT_EQ(topology->handles, c.handles);
    EXPECT_EQ(topology->loops.size(), c.loops);
  }
}

TEST(BoundaryOfDisk, SaysWhatIsNoDiskAndWhere) {
  SurfaceMesh not_finite = FlatSquare(1, 1);
  not_finite.points_mm[2].z() = std::numeric_limits<double>::quiet_NaN();
  SurfaceMesh beyond = FlatSquare(1, 1);
  beyond.triangles[1][2] = 9;
  SurfaceMesh flat = FlatSquare(1, 1);
  flat.points_mm[1] = {0.5, 0.5, 0};
  SurfaceMesh turned = FlatSquare(1, 1);
  std::swap(turned.triangles[1][1], turned.triangles[1][2]);
  SurfaceMesh touching = FlatSquare(2, 2);
  touching.triangles = {touching.triangles[0], touching.triangles[7]};
  SurfaceMesh apart = FlatSquare(3, 3);
  apart.triangles = {apart.triangles.front(), apart.triangles.back()};
  const struct {
    std::string name;
    SurfaceMesh mesh;
    Reason reason;
    std::string says;
  } cases[] = {
      {"nothing", {}, Reason::kMeshEmpty, "no triangles"},
      {"not finite", not_finite, Reason::kMeshNotFinite, "vertex 3"},
      {"index beyond", beyond, Reason::kMeshMalformed, "triangle 2 refers to vertex 10 of 4"},
      {"no area", flat, Reason::kMeshMalformed, "triangle 1 at (0.000, 0.000, 0.000) has no area"},
      {"wound against each other", turned, Reason::kMeshMalformed,
       "from (1.000, 1.000, 0.000) to (0.000, 0.000, 0.000)"},
      {"touching at a vertex", touching, Reason::kMeshMalformed,
       "touch only at the vertex (1.000, 1.000, 0.000)"},
      {"two parts", apart, Reason::kMeshMalformed, "2 separate parts"},
      {"closed", Tetrahedron(), Reason::kMeshMalformed, "closed"},
      {"handle", TorusWithAHole(), Reason::kMeshMalformed, "handles (1)"},
  };
  for (const auto& c : cases) {
    const auto loops = BoundaryOfDisk(c.mesh);
    ASSERT_FALSE(loops.ok()) << c.name;
    EXPECT_EQ(DetailOf(loops.status()).reason, c.reason) << c.name;
    EXPECT_THAT(std::string(loops.status().message()), testing::HasSubstr(c.says)) << c.name;
  }
}

}  // namespace
}  // namespace slicefarm::texture::disk_test
