#pragma once

#include "common/kinematics/kinematic_move.h"

namespace slicefarm {

/// Returns the profile of a move between given speeds. The cruise speed is lowered to the greatest
/// speed that the length allows. Units: squared speeds in mm^2/s^2. REQUIRES: |exit_v2 - entry_v2|
/// <= 2 a L, up to rounding, with the move's acceleration a and length L. Source: v^2 = v0^2 + 2 a
/// s.
MoveProfile Trapezoid(const KinematicMove& move, double entry_v2, double cruise_v2, double exit_v2);

/// Returns the time in s of a move that begins and ends at a standstill.
double RestToRest(double length_mm, double speed_mm_s, double acceleration_mm_s2);

}  // namespace slicefarm
