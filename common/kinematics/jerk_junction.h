#pragma once

#include "common/kinematics/jerk_ramp.h"
#include "common/kinematics/kinematic_move.h"

namespace slicefarm {

/// How a way bends where two straight moves meet.
struct Bend {
  double curvature = 0;  ///< 1/mm: of the circle that regular chords of their lengths lie on
  double corner = 0;     ///< 1/mm: of the arc that cuts the corner by the junction deviation
  bool sharp = false;    ///< turns by more than 45 degrees, or filament alone: no part of a curve
  bool stop = false;     ///< no way through at any speed
};

/// REQUIRES: both are limited. `deviation_mm`: > 0.
Bend BendBetween(const KinematicMove& before, const KinematicMove& move, double deviation_mm);

/// The greatest speed in mm/s through a bend whose curvature changes by `change` (1/mm^2): with k
/// the sharper of its curvatures, v <= sqrt(a / k) and, as the jerk at even speed is v^3 sqrt(k'^2
/// + k^4), v <= (j / sqrt(k'^2 + k^4))^(1/3). Infinite on a straight line.
double SpeedThrough(const Bend& bend, double change, const RampLimits& limits);

}  // namespace slicefarm
