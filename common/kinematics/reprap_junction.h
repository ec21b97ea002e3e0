#pragma once

#include "common/kinematics/kinematic_move.h"
#include "common/model/options/machine_limits.h"

namespace slicefarm {

/// The move with the speed and acceleration that RepRapFirmware's limits of each axis (M203, M201)
/// leave. What M204 asks for counts only for moves in x or y.
KinematicMove LimitedByRepRap(KinematicMove move, const MachineLimits& limits);

/// The greatest squared speed (mm^2/s^2) from `before` to `move` by jerk policy 0: the machine
/// stops between moves that are not alike (printing, other moves in x and y, z alone, extruder
/// alone); else no axis changes its speed by more than its limit (M566). REQUIRES: both are
/// limited. Source: RepRapFirmware's documentation, M566.
double RepRapJunctionV2(const KinematicMove& before, const KinematicMove& move,
                        const MachineLimits& limits);

}  // namespace slicefarm
