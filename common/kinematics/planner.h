#pragma once

#include <span>

#include "common/kinematics/kinematic_move.h"
#include "common/model/options/machine_limits.h"

namespace slicefarm {

/// Look-ahead over a sequence of moves that begins and ends at a standstill. The planner follows
/// the rules of a printer's firmware, so that the planned times equal the printer's times:
///   1 each move's speed and acceleration are lowered to the limits of the axes;
///   2 each junction with the previous move gets a greatest speed;
///   3 backward and forward passes lower these speeds until every move can reach its exit speed.
/// There is one class per firmware: klipper_planner.h, marlin_planner.h, reprap_planner.h. Only
/// jerk_planner.h follows no firmware.
///
/// The planner reuses its memory for each sequence. Two threads must not use it at the same time.
class Planner {
 public:
  explicit Planner(const MachineLimits& limits) : limits_(limits) {}
  virtual ~Planner() = default;
  Planner(const Planner&) = delete;
  Planner& operator=(const Planner&) = delete;

  /// Sets the limits of moves that are added from now on.
  void SetLimits(const MachineLimits& limits) { limits_ = limits; }

  /// Sets the jerk in x and y, or Klipper's square corner velocity, of moves that are added from
  /// now on.
  void SetJerk(double jerk_mm_s) {
    limits_.max_jerk_mm_s[kX] = limits_.max_jerk_mm_s[kY] = jerk_mm_s;
    limits_.square_corner_velocity_mm_s = jerk_mm_s;
  }

  /// Returns the move after step 1.
  virtual KinematicMove Limited(const KinematicMove& move) const = 0;

  /// Queues a move: steps 1 and 2, with the current limits.
  virtual void Add(const KinematicMove& move) = 0;

  /// Plans a stop after the move that was added last: step 3. Returns one profile for each move
  /// since the previous stop, valid until the next call. Cost: O(moves).
  virtual std::span<const MoveProfile> Stop() = 0;

  /// Plans a whole sequence of moves. REQUIRES: the queue is empty.
  std::span<const MoveProfile> Plan(std::span<const KinematicMove> moves) {
    for (const KinematicMove& move : moves) Add(move);
    return Stop();
  }

 protected:
  const MachineLimits& limits() const { return limits_; }

 private:
  MachineLimits limits_;
};

/// Returns by how much a move's acceleration can change the squared speed (mm^2/s^2) over the
/// move's length.
inline double ReachV2(const KinematicMove& move) {
  return 2 * move.length_mm * move.acceleration_mm_s2;
}

}  // namespace slicefarm
