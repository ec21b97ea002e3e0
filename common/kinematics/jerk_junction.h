#pragma once

#include "common/kinematics/jerk_ramp.h"
#include "common/kinematics/kinematic_move.h"

namespace slicefarm {

/// Bend of the path between two straight moves.
struct Bend {
  /// Curvature, in 1/mm, of the circle through regular chords of the moves' lengths.
  double curvature = 0;
  /// Curvature, in 1/mm, of the arc that cuts the corner by the junction deviation.
  double corner = 0;
  /// True if the path turns by more than 45 degrees, or only filament moves: the bend is not part
  /// of a curve.
  bool sharp = false;
  bool stop = false;  ///< true if the machine must stop here
};

/// Returns the bend between two moves. REQUIRES: both moves are results of Planner::Limited.
/// `deviation_mm`: > 0.
Bend BendBetween(const KinematicMove& before, const KinematicMove& move, double deviation_mm);

/// Returns the greatest speed in mm/s through a bend. `change`: change of the curvature along the
/// path, in 1/mm^2. Let k be the greater curvature of the bend's two ends, k' = `change`, and a and
/// j the limits. Then v <= sqrt(a / k). The jerk at constant speed is v^3 sqrt(k'^2 + k^4), so v <=
/// (j / sqrt(k'^2 + k^4))^(1/3). The result is infinite on a straight line.
double SpeedThrough(const Bend& bend, double change, const RampLimits& limits);

}  // namespace slicefarm
