#pragma once

#include "common/kinematics/kinematic_move.h"
#include "common/model/options/machine_limits.h"

namespace slicefarm {

/// Speed in mm/s at which Marlin's planner stops.
inline constexpr double kMarlinRestMmS = 0.05;

/// Returns the move with speed and acceleration within Marlin's limits of each axis. Limits of 0
/// are ignored. Moves slower than the minimum rates run at these rates.
KinematicMove LimitedByMarlin(KinematicMove move, const MachineLimits& limits);

/// Returns the greatest squared speed (mm^2/s^2) from `before` to `move` by junction deviation, in
/// x, y, z and e: v^2 = a jd s / (1 - s). s is the sine of half the angle between the directions,
/// jd the junction deviation, and a the acceleration that the axes allow in the direction of the
/// change. For a move shorter than 1 mm that turns by less than 45 degrees, v^2 is also at most
/// a L / angle: L is the length of `move`, and `angle` the turn in radians. REQUIRES: both moves
/// are results of LimitedByMarlin. Source: Marlin 2.1, Planner::_populate_block,
/// JUNCTION_DEVIATION.
double JunctionDeviationV2(const KinematicMove& before, const KinematicMove& move,
                           const MachineLimits& limits);

/// Returns the speed in mm/s at which a move may start and end without a ramp, by the jerk limits
/// of the axes.
double SafeSpeed(const KinematicMove& move, const MachineLimits& limits);

/// Returns the greatest speed in mm/s from `before` to `move` by classic jerk: no axis changes its
/// speed by more than its limit. If the SafeSpeed of both moves is above 99 % of this speed,
/// returns SafeSpeed of `move`. REQUIRES: both moves are results of LimitedByMarlin. Source: Marlin
/// 2.1, Planner::_populate_block, CLASSIC_JERK.
double ClassicJerkSpeed(const KinematicMove& before, const KinematicMove& move,
                        const MachineLimits& limits);

}  // namespace slicefarm
