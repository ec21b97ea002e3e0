#include "services/milling/algo/waterline/refine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "services/milling/algo/sample_parts_test.h"
#include "services/milling/algo/waterline/waterline.h"

namespace slicefarm::milling::refine_test {
namespace {

/// The corner of a box under a cylinder is a quarter of a circle. The refined loop follows it, and
/// straight walls get no points.
TEST(Refined, FollowsBendsOnly) {
  const TriangleMesh box = Box({0, 0, 0}, {20, 10, 5});
  const Cutter cutter = CutterOf("cyl:4");
  const auto plain = *Waterlines(box, cutter, std::vector{1.0}, {.sampling_mm = 1.1});
  size_t before = plain[0][0].points_mm.size();
  for (const double tolerance : {0.05, 0.01, 0.001}) {
    const auto fine =
        *Waterlines(box, cutter, std::vector{1.0},
                    {.sampling_mm = 1.1, .tolerance_mm = tolerance, .least_sampling_mm = 1e-3});
    ASSERT_EQ(fine[0].size(), 1u);
    const auto& points = fine[0][0].points_mm;
    EXPECT_GT(points.size(), before);
    EXPECT_LT(points.size(), 2 * before + 30);
    before = points.size();
    for (size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector2d& p = points[i];
      const Eigen::Vector2d middle = (p + points[(i + 1) % points.size()]) / 2;
      const auto off = [](const Eigen::Vector2d& q) {
        return (q - q.cwiseMax(0.0).cwiseMin(Eigen::Array2d(20, 10).matrix())).norm() - 2;
      };
      EXPECT_NEAR(off(p), 0, 1e-9);
      EXPECT_LT(std::abs(off(middle)), 2 * tolerance) << tolerance;
    }
  }
}

TEST(Refined, TouchesWhereItPutsPoints) {
  int points = 0;
  const TriangleMesh mesh = Waves(6, 8);
  for (const std::string_view text : kAllCutters) {
    const Cutter cutter = CutterOf(text);
    const auto levels = *Waterlines(
        mesh, cutter, std::vector{0.1},
        {.sampling_mm = 0.5, .tolerance_mm = 0.005, .least_sampling_mm = 0.01, .contacts = true});
    for (const WaterlineLoop& loop : levels[0]) {
      for (size_t i = 0; i < loop.points_mm.size(); i += 5) {
        ++points;
        const Eigen::Vector3d tip(loop.points_mm[i].x(), loop.points_mm[i].y(), loop.z_mm);
        EXPECT_GE(SampledClearance(mesh, cutter, tip, 24), -1e-8) << text;
        const Eigen::Vector3d contact = loop.contacts_mm[i] - tip;
        EXPECT_NEAR(contact.head<2>().norm(), cutter.Width(std::max(0.0, contact.z())), 1e-8)
            << text;
      }
    }
  }
  EXPECT_GT(points, 0);
}

}  // namespace
}  // namespace slicefarm::milling::refine_test
