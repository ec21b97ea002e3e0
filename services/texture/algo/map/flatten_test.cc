#include "services/texture/algo/map/flatten.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/base/error.h"
#include "services/texture/algo/map/distortion.h"
#include "services/texture/algo/map/exact_turn.h"
#include "services/texture/algo/surface/disk.h"
#include "services/texture/algo/surface/sample_surfaces_test.h"

namespace slicefarm::texture::flatten_test {
namespace {

/// Checks that no parts of the map overlap, by brute force over pairs of boundary edges. A map
/// without flips is one-to-one if its boundary does not cross itself.
void ExpectOneToOne(const SurfaceMesh& mesh, const FlatMap& map) {
  for (const auto& [a, b, c] : mesh.triangles)
    EXPECT_EQ(ExactTurn(map.points_mm[a], map.points_mm[b], map.points_mm[c]), 1);
  std::vector<std::array<int32_t, 2>> edges;
  const auto loops = BoundaryOfDisk(mesh);
  for (const BoundaryLoop& loop : *loops) {
    for (size_t i = 0; i < loop.size(); ++i)
      edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
  }
  for (size_t i = 0; i < edges.size(); ++i) {
    for (size_t k = 0; k < i; ++k) {
      const auto [a, b] = edges[i];
      const auto [c, d] = edges[k];
      if (a == c || a == d || b == c || b == d) continue;
      const auto turn = [&](int32_t p, int32_t q, int32_t r) {
        return ExactTurn(map.points_mm[p], map.points_mm[q], map.points_mm[r]);
      };
      EXPECT_FALSE(turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0)
          << "boundary edges " << a << " and " << c;
    }
  }
}

double EnergyOf(const SurfaceMesh& mesh, const FlatMap& map) {
  double energy = 0, area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const RestTriangle rest = RestOf(mesh.points_mm[a], mesh.points_mm[b], mesh.points_mm[c]);
    area += rest.area;
    energy += rest.area * SymmetricDirichlet(JacobianOf(rest, map.points_mm[a], map.points_mm[b],
                                                        map.points_mm[c]));
  }
  return energy / area / 4;
}

struct Case {
  std::string name;
  SurfaceMesh mesh;
  double most_energy = 0;
};

std::vector<Case> Cases() {
  const auto hole = [](const Eigen::Vector3d& p) { return std::hypot(p.x() - 4, p.y() - 6) < 2; };
  return {
      {"one square", FlatSquare(1, 3), 1 + 1e-6},
      {"flat square", FlatSquare(12, 20), 1 + 1e-6},
      {"half cylinder", HalfCylinder(16, 5, 12), 1 + 1e-5},
      {"square with a hole", Without(FlatSquare(14, 10), hole), 1 + 1e-6},
      {"half sphere", Cap(16, 0), 1.09},
      {"sphere with a small hole", Cap(24, -0.98), 4},
  };
}

TEST(Flatten, IsOneToOneAndOfLowDistortion) {
  for (const Case& c : Cases()) {
    SCOPED_TRACE(c.name);
    const auto map = Flatten(c.mesh);
    ASSERT_TRUE(map.ok()) << map.status();
    ASSERT_EQ(map->points_mm.size(), c.mesh.points_mm.size());
    ExpectOneToOne(c.mesh, *map);
    EXPECT_NEAR(map->mean_energy, EnergyOf(c.mesh, *map), 1e-9);
    EXPECT_LE(map->mean_energy, c.most_energy);
  }
}

TEST(Flatten, ASecondRunHasTheSameBytes) {
  const SurfaceMesh mesh = Cap(16, -0.9);
  const auto one = Flatten(mesh), other = Flatten(mesh);
  ASSERT_TRUE(one.ok() && other.ok());
  EXPECT_EQ(one->points_mm, other->points_mm);
}

TEST(Flatten, TheEnergyDependsOnTheShapeOnly) {
  const SurfaceMesh mesh = Cap(12, -0.5);
  SurfaceMesh moved = mesh;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (Eigen::Vector3d& p : moved.points_mm) p = 40 * (turn * p) + Eigen::Vector3d(100, -3, 7);
  SurfaceMesh shuffled = mesh;
  std::reverse(shuffled.triangles.begin(), shuffled.triangles.end());
  const double energy = Flatten(mesh)->mean_energy;
  // A map keeps its scale: a sphere of another size has another map with the same energy.
  EXPECT_NEAR(Flatten(moved)->mean_energy, energy, 1e-4);
  EXPECT_NEAR(Flatten(shuffled)->mean_energy, energy, 1e-4);
}

TEST(Flatten, UnusedVerticesDoNoHarm) {
  SurfaceMesh mesh = FlatSquare(4, 4);
  mesh.points_mm.push_back({7, 7, 7});
  const auto map = Flatten(mesh);
  ASSERT_TRUE(map.ok()) << map.status();
  EXPECT_NEAR(map->mean_energy, 1, 1e-6);
}

TEST(Flatten, CanBeCancelled) {
  const auto map = Flatten(Cap(12, -0.5), {}, CancelToken([] { return true; }));
  ASSERT_FALSE(map.ok());
  EXPECT_EQ(DetailOf(map.status()).reason, Reason::kCancelled);
}

TEST(Flatten, RefusesWhatIsNoDisk) {
  EXPECT_EQ(DetailOf(Flatten(SurfaceMesh{}).status()).reason, Reason::kMeshEmpty);
}

}  // namespace
}  // namespace slicefarm::texture::flatten_test
