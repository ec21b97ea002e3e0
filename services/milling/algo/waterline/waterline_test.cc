#include "services/milling/algo/waterline/waterline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "common/base/error.h"
#include "services/milling/algo/sample_parts_test.h"

namespace slicefarm::milling::waterline_test {
namespace {

using Levels = std::vector<std::vector<WaterlineLoop>>;

Levels Made(const TriangleMesh& mesh, std::string_view cutter, const std::vector<double>& z,
            double sampling = 0.25, int threads = 1) {
  const WaterlineOptions options{.sampling_mm = sampling, .contacts = true, .threads = threads};
  const auto levels = Waterlines(mesh, CutterOf(cutter), z, options);
  EXPECT_TRUE(levels.ok());
  return *levels;
}

double FarthestFromOrigin(const WaterlineLoop& loop) {
  double most = 0;
  for (const Eigen::Vector2d& p : loop.points_mm) most = std::max(most, p.norm());
  return most;
}

TEST(Waterlines, GoAroundASphereInCircles) {
  const TriangleMesh sphere = Sphere(5, 96);
  for (const double z : {-3.1, -1.0, 0.7, 2.9}) {
    const Levels levels = Made(sphere, "ball:4", {z});
    ASSERT_EQ(levels[0].size(), 1u);
    EXPECT_TRUE(levels[0][0].outer);
    const double up = std::max(0.0, z + 2), radius = std::sqrt(49 - up * up);
    for (const Eigen::Vector2d& p : levels[0][0].points_mm) EXPECT_NEAR(p.norm(), radius, 0.02);
  }
}

TEST(Waterlines, TellOuterFromInner) {
  TriangleMesh frame = Box({0, 0, 0}, {30, 5, 4});
  Append(frame, Box({0, 25, 0}, {30, 30, 4}));
  Append(frame, Box({0, 5, 0}, {5, 25, 4}));
  Append(frame, Box({25, 5, 0}, {30, 25, 4}));
  for (const std::string_view cutter : kAllCutters) {
    const Levels levels = Made(frame, cutter, {1});
    ASSERT_EQ(levels[0].size(), 2u) << cutter;
    EXPECT_NE(levels[0][0].outer, levels[0][1].outer) << cutter;
  }
}

/// No point gouges and each one touches, tested by a dense sample of the mesh; contacts are on the
/// cutter.
TEST(Waterlines, TouchEverywhereAndGougeNowhere) {
  const TriangleMesh mesh = Waves(6, 8);
  for (const std::string_view text : kAllCutters) {
    const Cutter cutter = CutterOf(text);
    for (const Levels levels = Made(mesh, text, {-0.6, 0.2, 0.7}, 0.4);
         const auto& level : levels) {
      EXPECT_FALSE(level.empty());
      for (const WaterlineLoop& loop : level) {
        ASSERT_EQ(loop.points_mm.size(), loop.contacts_mm.size());
        for (size_t i = 0; i < loop.points_mm.size(); i += 7) {
          const Eigen::Vector3d tip(loop.points_mm[i].x(), loop.points_mm[i].y(), loop.z_mm);
          const double clearance = SampledClearance(mesh, cutter, tip, 24);
          EXPECT_GE(clearance, -1e-8) << text;
          EXPECT_LE(clearance, 0.05) << text;
          const Eigen::Vector3d contact = loop.contacts_mm[i] - tip;
          EXPECT_NEAR(contact.head<2>().norm(), cutter.Width(std::max(0.0, contact.z())), 1e-8)
              << text;
        }
      }
    }
  }
}

TEST(Waterlines, TouchingAFlatIsNoHit) {
  TriangleMesh mesh = Box({-8, -8, 0}, {8, 8, 2});
  Append(mesh, Box({-2, -2, 2}, {2, 2, 5}));
  for (const std::string_view text : kAllCutters) {
    const Levels levels = Made(mesh, text, {2 + 1e-6, 2, 2 - 1e-6, 5, 5 - 1e-6});
    ASSERT_EQ(levels[0].size(), 1u) << text;
    ASSERT_EQ(levels[1].size(), 1u) << text;
    ASSERT_EQ(levels[2].size(), 1u) << text;
    EXPECT_LT(FarthestFromOrigin(levels[1][0]), 7.5) << text;  // around the tower
    EXPECT_GT(FarthestFromOrigin(levels[2][0]), 10) << text;   // around the plate
    EXPECT_TRUE(levels[3].empty()) << text;
    EXPECT_EQ(levels[4].size(), 1u) << text;
  }
}

/// A fiber exactly beside a wall touches it, for any grid.
TEST(Waterlines, FibersOnTheOffsetOfWallsAreFree) {
  const TriangleMesh box = Box({0, 0, 0}, {10, 10, 5});
  for (const double sampling : {0.5, 0.25, 0.3, 1.0}) {
    const Levels levels = Made(box, "cyl:4", {1}, sampling);
    ASSERT_EQ(levels[0].size(), 1u) << sampling;
    for (const Eigen::Vector2d& p : levels[0][0].points_mm) {
      const Eigen::Vector2d q = p - p.cwiseMax(0.0).cwiseMin(10.0);
      EXPECT_NEAR(q.norm(), 2, 1e-9) << sampling;
    }
  }
}

/// Returns the points of all loops, sorted.
std::vector<std::pair<double, double>> PointsOf(const Levels& levels) {
  std::vector<std::pair<double, double>> all;
  for (const auto& level : levels)
    for (const WaterlineLoop& loop : level)
      for (const Eigen::Vector2d& p : loop.points_mm) all.push_back({p.x(), p.y()});
  std::sort(all.begin(), all.end());
  return all;
}

TEST(Waterlines, DoNotDependOnTheOrderOfTrianglesOrThreads) {
  TriangleMesh mesh = Waves(7, 14);
  TriangleMesh shuffled = mesh;
  std::mt19937 random(2);
  std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), random);
  for (auto& t : shuffled.triangles) std::rotate(t.begin(), t.begin() + random() % 3, t.end());
  for (const std::string_view text : kAllCutters) {
    const auto points = PointsOf(Made(mesh, text, {0.5, -0.3}));
    EXPECT_EQ(points, PointsOf(Made(shuffled, text, {0.5, -0.3}))) << text;
    EXPECT_EQ(points, PointsOf(Made(mesh, text, {0.5, -0.3}, 0.25, 3))) << text;
    Levels levels = Made(mesh, text, {-0.3, 0.1, 0.5, 0.9});
    EXPECT_EQ(points, PointsOf({levels[2], levels[0]})) << text;
  }
}

/// A part turned by 90 degrees and mirrored gets the same loops, turned and mirrored.
TEST(Waterlines, TurnWithThePart) {
  const TriangleMesh mesh = Waves(7, 14);
  TriangleMesh turned = mesh, mirrored = mesh;
  for (Eigen::Vector3d& p : turned.points_mm) p = {-p.y(), p.x(), p.z()};
  for (Eigen::Vector3d& p : mirrored.points_mm) p.x() = -p.x();
  for (const std::string_view text : kAllCutters) {
    const Levels plain = Made(mesh, text, {0.4}), by_90 = Made(turned, text, {0.4}),
                 mirror = Made(mirrored, text, {0.4});
    ASSERT_EQ(plain[0].size(), by_90[0].size()) << text;
    ASSERT_EQ(plain[0].size(), mirror[0].size()) << text;
    double length = 0, length_90 = 0, length_mirror = 0;
    const auto lengths = [](const Levels& levels) {
      double sum = 0;
      for (const WaterlineLoop& loop : levels[0])
        for (size_t i = 0; i < loop.points_mm.size(); ++i)
          sum += (loop.points_mm[(i + 1) % loop.points_mm.size()] - loop.points_mm[i]).norm();
      return sum;
    };
    length = lengths(plain), length_90 = lengths(by_90), length_mirror = lengths(mirror);
    EXPECT_NEAR(length, length_90, 1e-6 * length) << text;
    EXPECT_NEAR(length, length_mirror, 1e-6 * length) << text;
    EXPECT_EQ(PointsOf(plain).size(), PointsOf(by_90).size()) << text;
  }
}

TEST(Waterlines, TakeHostileMeshes) {
  TriangleMesh mesh = Sphere(4, 16);
  TriangleMesh hostile = mesh;
  for (size_t i = 0; i < 40; ++i) hostile.triangles.push_back(mesh.triangles[i]);  // repeated
  hostile.triangles.push_back({5, 5, 5});
  hostile.triangles.push_back({5, 6, 6});
  const auto first = static_cast<uint32_t>(hostile.points_mm.size());
  hostile.points_mm.insert(hostile.points_mm.end(), {{0, 0, 1}, {1e-9, 0, 1}, {0, 1e-12, 1}});
  hostile.triangles.push_back({first, first + 1, first + 2});
  for (const std::string_view text : kAllCutters) {
    EXPECT_EQ(PointsOf(Made(mesh, text, {-1, 0, 1})), PointsOf(Made(hostile, text, {-1, 0, 1})))
        << text;
  }
  TriangleMesh open = mesh;
  open.triangles.resize(open.triangles.size() / 2);
  for (const std::string_view text : kAllCutters)
    for (const Levels levels = Made(open, text, {0.5, 1, 2}); const auto& level : levels)
      EXPECT_FALSE(level.empty()) << text;
  TriangleMesh dot;
  dot.points_mm = {{1, 1, 1}};
  dot.triangles = {{0, 0, 0}};
  const Levels around_dot = Made(dot, "ball:4", {0});
  ASSERT_EQ(around_dot[0].size(), 1u);
  for (const Eigen::Vector2d& p : around_dot[0][0].points_mm)
    EXPECT_NEAR((p - Eigen::Vector2d(1, 1)).norm(), std::sqrt(3), 1e-12);
}

TEST(Waterlines, RefusesWhatIsNoWork) {
  const TriangleMesh mesh = Sphere(4, 16);
  const Cutter cutter = CutterOf("ball:4");
  const std::vector<double> z = {0};
  const auto reason = [&](const TriangleMesh& m, const std::vector<double>& levels,
                          double sampling) {
    return DetailOf(Waterlines(m, cutter, levels, {.sampling_mm = sampling}).status()).reason;
  };
  EXPECT_EQ(reason({}, z, 0.2), Reason::kMeshEmpty);
  EXPECT_EQ(reason(mesh, z, 0), Reason::kSettingOutOfRange);
  EXPECT_EQ(reason(mesh, z, std::numeric_limits<double>::quiet_NaN()), Reason::kSettingOutOfRange);
  EXPECT_EQ(reason(mesh, {std::numeric_limits<double>::infinity()}, 0.2),
            Reason::kSettingOutOfRange);
  EXPECT_EQ(reason(mesh, z, 1e-9), Reason::kRequestTooLarge);
  const auto cancelled = Waterlines(mesh, cutter, z, {}, CancelToken([] { return true; }));
  EXPECT_EQ(cancelled.status().code(), absl::StatusCode::kCancelled);
}

/// Adding points to one level's loop may take seconds, so the token is checked for each point.
TEST(Waterlines, AreCancelledWithinALevel) {
  const TriangleMesh mesh = Sphere(4, 16);
  const Cutter cutter = CutterOf("ball:4");
  const std::vector<double> z = {0};
  const auto looks_of = [&](double tolerance_mm) {
    int64_t looks = 0;
    const auto made = Waterlines(mesh, cutter, z, {.tolerance_mm = tolerance_mm},
                                 CancelToken([&] { return ++looks < 0; }));
    EXPECT_TRUE(made.ok());
    return looks;
  };
  const int64_t looks = looks_of(1e-4);
  EXPECT_GT(looks, looks_of(0) + 50);
  int64_t asked = 0;
  const auto cancelled = Waterlines(mesh, cutter, z, {.tolerance_mm = 1e-4},
                                    CancelToken([&] { return asked++ > looks - 20; }));
  EXPECT_EQ(cancelled.status().code(), absl::StatusCode::kCancelled);
}

}  // namespace
}  // namespace slicefarm::milling::waterline_test
