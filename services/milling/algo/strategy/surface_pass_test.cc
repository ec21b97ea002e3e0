#include "services/milling/algo/strategy/surface_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slicefarm::milling::surface_pass_test {
namespace {

TEST(SurfacePass, IsStraightOnAPlane) {
  const auto pass = SurfacePass({0, 0, 1}, {3, 4, 2}, 0.01,
                                [](const Eigen::Vector2d& p) { return 1 + p.norm() / 5; });
  ASSERT_EQ(pass.size(), 1u);
  EXPECT_EQ(pass[0], Eigen::Vector3d(3, 4, 2));
}

/// A bull nose begins to climb a step, for any position of the step.
TEST(SurfacePass, FindsTheFootOfAStep) {
  for (double foot = 0.05; foot < 0.95; foot += 0.0173) {
    const auto height = [foot](const Eigen::Vector2d& p) {
      const double d = std::max(0.0, 0.5 - std::max(0.0, p.x() - foot));
      return p.x() <= foot ? 0 : std::min(0.3, std::sqrt(0.25 - d * d));
    };
    Eigen::Vector3d last(0, 0, 0);
    const std::vector<Eigen::Vector3d> pass = SurfacePass(last, {1, 0, 0.3}, 0.01, height);
    ASSERT_FALSE(pass.empty()) << foot;
    for (const Eigen::Vector3d& p : pass) {
      for (double share = 0; share < 1; share += 0.1) {
        const Eigen::Vector3d q = last + share * (p - last);
        // The path may be as low as one 0.005 mm to the side.
        EXPECT_GE(q.z(), height({q.x() - 0.005, 0}) - 0.005) << foot << " " << q.transpose();
      }
      last = p;
    }
  }
}

TEST(SurfacePass, GoesStraightOverWhatIsUnknown) {
  const auto nothing = [](const Eigen::Vector2d&) {
    return -std::numeric_limits<double>::infinity();
  };
  EXPECT_EQ(SurfacePass({0, 0, 0}, {1, 0, 0}, 0.01, nothing).size(), 1u);
}

}  // namespace
}  // namespace slicefarm::milling::surface_pass_test
