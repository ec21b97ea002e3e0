#pragma once

#include "common/kinematics/kinematic_move.h"
#include "common/model/options/machine_limits.h"

namespace slicefarm {

/// The move with the speed and acceleration that Klipper's limits leave: the toolhead's speed, the
/// z axis' share, and for retractions (also while wiping) and other moves of filament without x and
/// y those of the extruder, which do not depend on the toolhead's. Sets corner_v2.
KinematicMove LimitedByKlipper(KinematicMove move, const MachineLimits& limits);

/// The greatest squared speed (mm^2/s^2) at which Klipper goes from `before` to `move`, as far as
/// their directions say:
///   junction deviation by the square corner velocity, v^2 = scv^2 (sqrt(2) - 1) s / (1 - s),
///   s the sine of half the angle between the moves;
///   the arc that fits in half of either move, v^2 <= a L tan(theta / 2) / 2;
///   the extruder's speed may change by 1 mm/s at once.
/// Where one of the moves is the extruder's alone, the toolhead stops: 0. REQUIRES: both are
/// limited. Source: Klipper's documentation, "Kinematics".
double KlipperJunctionV2(const KinematicMove& before, const KinematicMove& move);

}  // namespace slicefarm
