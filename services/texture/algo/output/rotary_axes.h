#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "processes/engrave/model/engrave_settings.h"

namespace slicefarm::texture {

using slicefarm::AxisLayout;

/// A machine's axes. Angles in degrees; positive ones turn counter-clockwise as seen from the end
/// of the axis they turn about.
struct AxisOptions {
  AxisLayout layout = AxisLayout::kTableBc;
  /// Where a table's axes meet, in the part's coordinates.
  Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();
  double pivot_mm = 100;  ///< from where a head's axes meet to the tip
  double tilt_deg = 110;  ///< most, either way: of B with C; of A and of B
};

/// What the machine is told: X, Y, Z and two angles (A and B, or B and C).
struct AxisPlace {
  Eigen::Vector3d xyz_mm = Eigen::Vector3d::Zero();
  Eigen::Vector2d angles_deg = Eigen::Vector2d::Zero();
};

/// Between the tool on the part and a machine's axes.
class RotaryAxes {
 public:
  explicit RotaryAxes(const AxisOptions& options) : options_(options) {}

  /// The letters of the angles; blanks: none.
  const char* Letters() const;

  /// Angles at which the tool points against `normal`: of the two solutions within the limits, each
  /// with whole turns of C to choose from, the one next to `before`. Where C does not matter it
  /// stays. None: the limits keep it off.
  std::optional<Eigen::Vector2d> AnglesFor(const Eigen::Vector3d& normal,
                                           const Eigen::Vector2d& before) const;

  /// X, Y and Z with which the tip is at a place of the part at these angles.
  Eigen::Vector3d XyzFor(const Eigen::Vector3d& place_mm, const Eigen::Vector2d& angles_deg) const;
  /// The place of the part at which the tip is.
  Eigen::Vector3d TipAt(const AxisPlace& at) const;

 private:
  AxisOptions options_;
};

}  // namespace slicefarm::texture
