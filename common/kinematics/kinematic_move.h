#pragma once

#include <array>

namespace slicefarm {

enum Axis { kX = 0, kY = 1, kZ = 2, kE = 3 };

/// Straight move that starts from a standstill or from the previous move, as in the planner of a
/// firmware.
struct KinematicMove {
  /// length of the nozzle's path, or of the filament if nothing else moves; must be > 0
  double length_mm = 0;
  std::array<double, 4> ratio = {};  ///< mm of x, y, z and e per mm of length
  double speed_mm_s = 0;             ///< upper limit of the speed; must be > 0
  /// upper limit, must be > 0: the firmware's acceleration for this kind of move, before the axes'
  /// limits (Firmware::AccelerationFor)
  double acceleration_mm_s2 = 0;

  /// Only for Klipper, set by LimitedByKlipper: squared speed at a corner with s = 1/2, where s is
  /// the sine of half the angle between the moves (klipper_junction.h).
  double corner_v2 = 0;

  /// Returns true if only the filament moves.
  bool ExtruderOnly() const { return ratio[kX] == 0 && ratio[kY] == 0 && ratio[kZ] == 0; }
  /// Returns true if the nozzle moves in x or y.
  bool InPlane() const { return ratio[kX] != 0 || ratio[kY] != 0; }
};

/// Speed profile of a move: it accelerates from `entry`, continues at `cruise` and decelerates to
/// `exit`. Both changes use the move's acceleration.
struct MoveProfile {
  double entry_mm_s = 0;
  double cruise_mm_s = 0;
  double exit_mm_s = 0;
  double time_s = 0;
};

}  // namespace slicefarm
