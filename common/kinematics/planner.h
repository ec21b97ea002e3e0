#pragma once

#include <span>

#include "common/kinematics/kinematic_move.h"
#include "common/model/options/machine_limits.h"

namespace slicefarm {

/// Look-ahead over a run of moves that begins and ends at rest, by the rules of a printer's
/// firmware, so that its times are the printer's times:
///   1 each move's speed and acceleration are lowered to the limits of the axes;
///   2 each junction with the move before gets a greatest speed;
///   3 backward and forward passes lower these until every move can reach its exit speed.
/// One class a firmware: klipper_planner.h, marlin_planner.h, reprap_planner.h.
///
/// Keeps its memory from run to run. Not for use by two threads at once.
class Planner {
 public:
  explicit Planner(const MachineLimits& limits) : limits_(limits) {}
  virtual ~Planner() = default;
  Planner(const Planner&) = delete;
  Planner& operator=(const Planner&) = delete;

  /// Of the moves that are added from now on.
  void SetLimits(const MachineLimits& limits) { limits_ = limits; }

  /// Step 1 alone.
  virtual KinematicMove Limited(const KinematicMove& move) const = 0;

  /// Queues a move. Steps 1 and 2, by the limits of now.
  virtual void Add(const KinematicMove& move) = 0;

  /// The machine comes to rest after the move added last: step 3. One profile a move since the stop
  /// before, valid until the next call. Cost: O(moves).
  virtual std::span<const MoveProfile> Stop() = 0;

  /// A whole run. REQUIRES: nothing is queued.
  std::span<const MoveProfile> Plan(std::span<const KinematicMove> moves) {
    for (const KinematicMove& move : moves) Add(move);
    return Stop();
  }

 protected:
  const MachineLimits& limits() const { return limits_; }

 private:
  MachineLimits limits_;
};

/// How much the squared speed can change over a move.
inline double ReachV2(const KinematicMove& move) {
  return 2 * move.length_mm * move.acceleration_mm_s2;
}

}  // namespace slicefarm
