#include "services/texture/algo/output/rotary_axes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace slicefarm::texture::rotary_axes_test {
namespace {

Eigen::Matrix3d About(const Eigen::Vector3d& axis, double degrees) {
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis).toRotationMatrix();
}

/// Returns the tool's direction in the part, computed independently from the meaning of the axes.
Eigen::Vector3d ToolIn(AxisLayout layout, const Eigen::Vector2d& angles) {
  const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  switch (layout) {
    case AxisLayout::kNone:
      return z;
    case AxisLayout::kTableAb:
      return (About(x, angles[0]) * About(y, angles[1])).inverse() * z;
    case AxisLayout::kTableBc:
      return (About(y, angles[0]) * About(z, angles[1])).inverse() * z;
    case AxisLayout::kHeadAb:
      return About(y, angles[1]) * About(x, angles[0]) * z;
    case AxisLayout::kHeadBc:
      return About(z, angles[1]) * About(y, angles[0]) * z;
  }
  return z;
}

constexpr AxisLayout kLayouts[] = {AxisLayout::kTableAb, AxisLayout::kTableBc, AxisLayout::kHeadAb,
                                   AxisLayout::kHeadBc};

TEST(RotaryAxes, PointTheToolAgainstTheNormal) {
  for (const AxisLayout layout : kLayouts) {
    const RotaryAxes axes({.layout = layout, .centre_mm = {3, -4, 5}, .tilt_deg = 180});
    for (int i = 0; i < 500; ++i) {
      const double z = 2 * (i + 0.5) / 500 - 1, turn = i * 2.4;
      const double flat = std::sqrt(1 - z * z);
      const Eigen::Vector3d normal(flat * std::cos(turn), flat * std::sin(turn), z);
      const auto angles = axes.AnglesFor(normal, {10, -700});
      ASSERT_TRUE(angles.has_value());
      EXPECT_LT((ToolIn(layout, *angles) - normal).norm(), 1e-12);
      const Eigen::Vector3d place(12, 7, -30);
      const AxisValues at{axes.XyzFor(place, *angles), *angles};
      EXPECT_LT((axes.TipAt(at) - place).norm(), 1e-10);
    }
  }
}

TEST(RotaryAxes, GoOnFromTheAnglesBefore) {
  const RotaryAxes axes({.layout = AxisLayout::kTableBc});
  Eigen::Vector2d before(0, 0);
  // During three turns around a cone, C continues to turn and B stays.
  for (int i = 0; i <= 1080; ++i) {
    const double turn = i * std::numbers::pi / 180;
    const auto angles = axes.AnglesFor({0.6 * std::cos(turn), 0.6 * std::sin(turn), 0.8}, before);
    ASSERT_TRUE(angles.has_value());
    if (i > 0) {
      EXPECT_LT((*angles - before).cwiseAbs().maxCoeff(), 1.001);
    }
    before = *angles;
  }
  EXPECT_NEAR(std::abs(before[1]), 1080, 181);
}

TEST(RotaryAxes, StayWhereCDoesNotMatter) {
  const RotaryAxes axes({.layout = AxisLayout::kHeadBc});
  EXPECT_EQ(axes.AnglesFor({0, 0, 1}, {20, 77}), Eigen::Vector2d(0, 77));
}

TEST(RotaryAxes, KeepToTheirLimits) {
  for (const AxisLayout layout : kLayouts) {
    const RotaryAxes axes({.layout = layout, .tilt_deg = 60});
    EXPECT_FALSE(axes.AnglesFor({0, 0, -1}, {0, 0}).has_value());
    EXPECT_FALSE(
        axes.AnglesFor(Eigen::Vector3d(0.95, 0, std::sqrt(1 - 0.95 * 0.95)), {0, 0}).has_value());
    EXPECT_TRUE(axes.AnglesFor({0.6, 0, 0.8}, {0, 0}).has_value());
  }
}

}  // namespace
}  // namespace slicefarm::texture::rotary_axes_test
