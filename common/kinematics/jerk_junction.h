#pragma once

#include "common/kinematics/jerk_ramp.h"
#include "common/kinematics/kinematic_move.h"

namespace slicefarm {

/// Bend of the path between two straight moves.
struct Bend {
  /// Curvature, in 1/mm, of a circle with two chords that meet at the angle of the moves. Both
  /// chords have the mean length of the moves.
  double curvature = 0;
  /// Curvature, in 1/mm, of the arc that rounds the corner, with the junction deviation as the
  /// arc's distance from the corner.
  double corner = 0;
  /// True if the path turns by more than 45 degrees, or if only filament moves before or after the
  /// bend. Such a bend is not part of a curve.
  bool sharp = false;
  bool stop = false;  ///< true if the machine must stop at the bend
};

/// Returns the bend between two moves. `deviation_mm`: junction deviation. REQUIRES: both moves are
/// results of Planner::Limited; deviation_mm > 0.
Bend BendBetween(const KinematicMove& before, const KinematicMove& move, double deviation_mm);

/// Returns the greatest speed in mm/s through a bend. `change`: change of the curvature along the
/// path, in 1/mm^2. Let k be the greater of the bend's `curvature` and `corner`, k' = `change`, and
/// a and j the limits. Then v <= sqrt(a / k). The jerk at constant speed is v^3 sqrt(k'^2 + k^4),
/// so v <= (j / sqrt(k'^2 + k^4))^(1/3). The result is infinite on a straight line.
double SpeedThrough(const Bend& bend, double change, const RampLimits& limits);

}  // namespace slicefarm
