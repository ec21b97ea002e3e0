#pragma once

#include "common/kinematics/kinematic_move.h"
#include "common/model/options/machine_limits.h"

namespace slicefarm {

/// Returns the move with speed and acceleration within Klipper's limits. Moves in x, y or z are
/// limited by the toolhead and by the z axis. Retractions (also during a wipe) and filament moves
/// without x and y are limited by the extruder, too. The extruder's limits do not depend on the
/// toolhead's. Sets corner_v2.
KinematicMove LimitedByKlipper(KinematicMove move, const MachineLimits& limits);

/// Returns the greatest squared speed (mm^2/s^2) at Klipper's junction from `before` to `move`.
///
/// The result is the smallest of these limits, which depend on the directions:
///   junction deviation by the square corner velocity, v^2 = scv^2 (sqrt(2) - 1) s / (1 - s),
///   s the sine of half the angle between the moves;
///   the arc that fits in half of either move, v^2 <= a L tan(theta / 2) / 2;
///   theta is the angle between the moves, L the move's length, a its acceleration;
///   the extruder's speed may change by 1 mm/s at once.
/// Returns 0 if one of the moves is of the extruder alone, because the toolhead stops. REQUIRES:
/// both moves are results of LimitedByKlipper. Source: Klipper's documentation, "Kinematics".
double KlipperJunctionV2(const KinematicMove& before, const KinematicMove& move);

}  // namespace slicefarm
