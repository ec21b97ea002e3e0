#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "processes/engrave/model/engrave_settings.h"

namespace slicefarm::texture {

using slicefarm::AxisLayout;

/// Axes of a machine. Angles are in degrees. Positive angles are counter-clockwise as seen from the
/// positive end of the rotation axis.
struct AxisOptions {
  AxisLayout layout = AxisLayout::kTableBc;
  /// Point where a table's rotary axes intersect, in the part's coordinates.
  Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();
  double pivot_mm = 100;  ///< distance from the intersection of a head's axes to the tip
  /// largest angle in both directions: of B for layouts with C, otherwise of A and of B
  double tilt_deg = 110;
};

/// Axis values of the machine: X, Y, Z and two angles (A and B, or B and C).
struct AxisPlace {
  Eigen::Vector3d xyz_mm = Eigen::Vector3d::Zero();
  Eigen::Vector2d angles_deg = Eigen::Vector2d::Zero();
};

/// Converts between the tool on the part and a machine's axes.
class RotaryAxes {
 public:
  explicit RotaryAxes(const AxisOptions& options) : options_(options) {}

  /// Returns the letters of the two angles; blanks if there are none.
  const char* Letters() const;

  /// Returns the angles at which the tool points against `normal`. Two solutions are possible, and
  /// whole turns may be added to C. The function returns the solution within the limits that is
  /// closest to `before`. If any C is possible, C does not turn. Returns nullopt if no solution is
  /// within the limits.
  std::optional<Eigen::Vector2d> AnglesFor(const Eigen::Vector3d& normal,
                                           const Eigen::Vector2d& before) const;

  /// Returns X, Y and Z of the machine at which the tip is at `place_mm` on the part, with the
  /// angles `angles_deg`.
  Eigen::Vector3d XyzFor(const Eigen::Vector3d& place_mm, const Eigen::Vector2d& angles_deg) const;
  /// Returns the position of the tip on the part.
  Eigen::Vector3d TipAt(const AxisPlace& at) const;

 private:
  AxisOptions options_;
};

}  // namespace slicefarm::texture
