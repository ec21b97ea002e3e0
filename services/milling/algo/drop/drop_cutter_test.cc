#include "services/milling/algo/drop/drop_cutter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "services/milling/algo/sample_parts_test.h"

namespace slicefarm::milling::drop_cutter_test {
namespace {

struct DropCase {
  const char* name;
  const char* cutter;
  Eigen::Vector2d place;
  double z;
};

TEST(DropCutter, RestsWhereGeometrySays) {
  const TriangleMesh box = Box({0, 0, 0}, {10, 10, 5});
  for (const DropCase& c : {
           DropCase{"on a flat, cylinder", "cyl:4", {5, 5}, 5},
           DropCase{"on a flat, ball", "ball:4", {5, 5}, 5},
           DropCase{"on a flat, cone", "cone:4:45", {5, 5}, 5},
           DropCase{"over an edge, cylinder", "cyl:4", {-1, 5}, 5},
           DropCase{"over an edge, ball", "ball:4", {-1, 5}, 3 + std::sqrt(3)},
           DropCase{"over an edge, bull", "bull:4:1", {-1.5, 5}, 4 + std::sqrt(0.75)},
           DropCase{"over an edge, cone", "cone:4:45", {-1, 5}, 4},
           DropCase{"over a corner, ball", "ball:4", {-1, -1}, 3 + std::sqrt(2)},
       }) {
    const auto drop = DropCutter(box, CutterOf(c.cutter)).At(c.place);
    ASSERT_TRUE(drop.has_value()) << c.name;
    EXPECT_NEAR(drop->z_mm, c.z, 1e-12) << c.name;
  }
  EXPECT_FALSE(DropCutter(box, CutterOf("ball:4")).At({-2.1, 5}).has_value());
}

/// The ridge runs up a slope, far from the origin. All contacts are on the edge, at the cutter's
/// rim, and rounding must not put them beside the cutter.
TEST(DropCutter, RestsOnRidges) {
  for (const std::string_view text : kAllCutters) {
    for (const double turn : {0.0, 0.3, 1.1}) {
      const double c = std::cos(turn), s = std::sin(turn);
      const auto at = [&](double u, double v) {
        return Eigen::Vector3d(121.3 + c * u - s * v, 163.7 + s * u + c * v,
                               100 + 0.26 * u - 1e-3 * std::abs(v));
      };
      TriangleMesh mesh;
      mesh.points_mm = {at(-19.3, 0), at(23.7, 0), at(0, 20), at(0, -20)};
      mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
      const Cutter cutter = CutterOf(text);
      const DropCutter dropper(mesh, cutter);
      const double rest = dropper.At(at(0.123, 0).head<2>())->z_mm;
      for (double u = -8; u < 8; u += 0.0317) {
        const auto drop = dropper.At(at(u, 0).head<2>());
        ASSERT_TRUE(drop.has_value());
        ASSERT_NEAR(drop->z_mm, rest + 0.26 * (u - 0.123), 1e-9) << text << turn << " " << u;
      }
    }
  }
}

/// The upper end of the slope is exactly on the rim. It is under the cutter up to there, even if
/// rounding puts the end slightly beside it.
TEST(DropCutter, RestsOnSlopesThatEndOnTheRim) {
  TriangleMesh mesh;
  mesh.points_mm = {{-20, 132, 14}, {20, 132, 14}, {20, 134, 13}, {-20, 134, 13}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Cutter cutter = CutterOf("cyl:6");
  const DropCutter dropper(mesh, cutter);
  for (double x = -9; x < 9; x += 0.173) EXPECT_NEAR(dropper.At({x, 135})->z_mm, 14, 1e-9) << x;
  EXPECT_LT(dropper.At({0, 135 + 1e-6})->z_mm, 14);
  EXPECT_GT(dropper.At({0, 135 + 1e-6})->z_mm, 14 - 1e-5);
}

/// A position is gouged with the tip at z if and only if the cutter rests higher there.
TEST(DropCutter, IsTheDualOfThePushCutter) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(-3, 3);
  for (const std::string_view text : kAllCutters) {
    const Cutter cutter = CutterOf(text);
    int rests = 0;
    for (int round = 0; round < 300; ++round) {
      TriangleMesh mesh = RandomTriangle(random, 3);
      if (round % 4 == 0) mesh.points_mm[1].z() = mesh.points_mm[0].z();
      if (round % 5 == 0) mesh.points_mm[1].head<2>() = mesh.points_mm[0].head<2>();
      const MeshEdges edges = EdgesOf(mesh);
      const FiberFrame frame(mesh, edges, FiberAxis::kX);
      const DropCutter dropper(mesh, cutter);
      const Eigen::Vector2d place(any(random), any(random));
      const auto gouged = [&](double z) {
        const Interval i = frame.PushTriangle(cutter, 0, {place.y(), z});
        return i.low < place.x() && place.x() < i.high;
      };
      const auto drop = dropper.At(place);
      if (!drop) {
        EXPECT_FALSE(gouged(-20)) << text << round;
        continue;
      }
      ++rests;
      EXPECT_FALSE(gouged(drop->z_mm + 1e-8)) << text << " " << round;
      EXPECT_TRUE(gouged(drop->z_mm - 1e-8)) << text << " " << round;
      const double distance = (drop->contact_mm.head<2>() - place).norm();
      EXPECT_NEAR(drop->contact_mm.z() - drop->z_mm,
                  cutter.HeightAt(std::min(distance, cutter.radius_mm())), 1e-7);
    }
    EXPECT_GT(rests, 60) << text;
  }
}

}  // namespace
}  // namespace slicefarm::milling::drop_cutter_test
