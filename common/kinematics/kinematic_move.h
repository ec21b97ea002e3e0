#pragma once

#include <array>

namespace slicefarm {

enum Axis { kX = 0, kY = 1, kZ = 2, kE = 3 };

/// A straight move from rest or from the previous move, as in the planner of a firmware.
struct KinematicMove {
  double length_mm = 0;  ///< > 0: path of the nozzle, or of the filament if nothing else moves
  std::array<double, 4> ratio = {};  ///< mm of x, y, z and e per mm of length
  double speed_mm_s = 0;             ///< > 0: upper limit
  double acceleration_mm_s2 = 0;     ///< > 0: upper limit; the machine's setting for any move

  /// Value of a limited move for Klipper: squared speed at a corner where the sine of half the
  /// angle between the moves is half of 1.
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
