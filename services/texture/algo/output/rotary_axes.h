#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "processes/engrave/model/engrave_settings.h"

namespace slicefarm::texture {

using slicefarm::AxisLayout;

/// Arrangement of a machine's rotary axes. Angles are in degrees. Positive angles are
/// counter-clockwise as seen from the positive end of the rotation axis.
struct AxisOptions {
  AxisLayout layout = AxisLayout::kTableBc;
  /// Intersection of a table's rotary axes, in the part's coordinates.
  Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();
  double pivot_mm = 100;  ///< distance from the intersection of a head's axes to the tip
  /// largest tilt angle in both directions: of B in a layout with C, otherwise of A and of B
  double tilt_deg = 110;
};

/// Axis values of the machine: X, Y, Z and two angles (A and B, or B and C).
struct AxisValues {
  Eigen::Vector3d xyz_mm = Eigen::Vector3d::Zero();
  Eigen::Vector2d angles_deg = Eigen::Vector2d::Zero();
};

/// Converts between positions of the tool on the part and axis values of a machine.
class RotaryAxes {
 public:
  explicit RotaryAxes(const AxisOptions& options) : options_(options) {}

  /// Returns the letters of the two angles; blanks if there are none.
  const char* Letters() const;

  /// Returns the pair of angles at which the tool points against `normal`. There are two such
  /// pairs, and C may also turn by any number of whole turns. Returns the pair within the limits
  /// that is closest to `before`. If `normal` is vertical, the direction does not depend on C; then
  /// C keeps its angle from `before`. Returns nullopt if no pair is within the limits. Without
  /// rotary axes, both angles are 0.
  std::optional<Eigen::Vector2d> AnglesFor(const Eigen::Vector3d& normal,
                                           const Eigen::Vector2d& before) const;

  /// Returns the machine's X, Y and Z that put the tip at `place_mm` on the part, if the axes have
  /// the angles `angles_deg`.
  Eigen::Vector3d XyzFor(const Eigen::Vector3d& place_mm, const Eigen::Vector2d& angles_deg) const;
  /// Returns the position of the tip in the part's coordinates.
  Eigen::Vector3d TipAt(const AxisValues& at) const;

 private:
  AxisOptions options_;
};

}  // namespace slicefarm::texture
