#pragma once

#include "common/kinematics/kinematic_move.h"
#include "common/model/options/machine_limits.h"

namespace slicefarm {

/// Marlin's planner comes to a stop at this speed, in mm/s.
inline constexpr double kMarlinRestMmS = 0.05;

/// The move with the speed and acceleration that Marlin's limits of each axis leave. Limits of 0 do
/// not count. What is slower than the least rates runs at these.
KinematicMove LimitedByMarlin(KinematicMove move, const MachineLimits& limits);

/// The greatest squared speed (mm^2/s^2) from `before` to `move` by junction deviation, as far as
/// their directions in x, y, z and e say: v^2 = a jd s / (1 - s), s the sine of half the angle
/// between them, a what the axes allow in the direction of the change; for moves below 1 mm that
/// turn by less than 45 degrees at most a L / turn. REQUIRES: both are limited. Source: Marlin 2.1,
/// Planner::_populate_block, JUNCTION_DEVIATION.
double JunctionDeviationV2(const KinematicMove& before, const KinematicMove& move,
                           const MachineLimits& limits);

/// Speed in mm/s from which a move may start and end at once, by the jerk limits of the axes.
double SafeSpeed(const KinematicMove& move, const MachineLimits& limits);

/// The greatest speed in mm/s from `before` to `move` by classic jerk: no axis changes its speed by
/// more than its limit. If either could as well stop, the safe speed. REQUIRES: both are limited.
/// Source: Marlin 2.1, Planner::_populate_block, CLASSIC_JERK.
double ClassicJerkSpeed(const KinematicMove& before, const KinematicMove& move,
                        const MachineLimits& limits);

}  // namespace slicefarm
