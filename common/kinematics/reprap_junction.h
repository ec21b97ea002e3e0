#pragma once

#include "common/kinematics/kinematic_move.h"
#include "common/model/options/machine_limits.h"

namespace slicefarm {

/// Returns the move with speed and acceleration within RepRapFirmware's limits of each axis (M203,
/// M201). The acceleration of M204 only applies to moves in x or y.
KinematicMove LimitedByRepRap(KinematicMove move, const MachineLimits& limits);

/// Returns the greatest squared speed (mm^2/s^2) from `before` to `move` by jerk policy 0. The
/// machine stops between moves of different kinds (printing, other moves in x and y, z alone,
/// extruder alone). Between moves of the same kind, no axis changes its speed by more than its
/// limit (M566). REQUIRES: both moves are results of LimitedByRepRap. Source: RepRapFirmware's
/// documentation, M566.
double RepRapJunctionV2(const KinematicMove& before, const KinematicMove& move,
                        const MachineLimits& limits);

}  // namespace slicefarm
