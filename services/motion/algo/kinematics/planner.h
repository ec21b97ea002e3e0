#pragma once

#include <span>
#include <vector>

#include "common/model/motion_options.h"
#include "services/motion/algo/kinematics/kinematic_move.h"

namespace slicefarm::motion {

/// The move within the limits of the axes, as the firmware has it: LimitedByKlipper or
/// LimitedByMarlin.
KinematicMove LimitedByFirmware(const KinematicMove& move, GcodeFlavor flavor,
                                const MachineLimits& limits);

/// Look-ahead over a run of moves that begins and ends at rest, by the rules of the printer's
/// firmware, so that its times are the printer's times:
///   1 each move's speed and acceleration are lowered to the limits of the axes;
///   2 each junction gets a greatest speed: marlin_junction.h or klipper_junction.h;
///   3 backward and forward passes lower these until every move can reach its exit speed;
///   4 Klipper besides lowers the peaks of moves that would speed up only to slow down at once
///   (minimum_cruise_ratio).
///
/// Keeps its memory from run to run. Not for use by two threads at once.
class Planner {
 public:
  Planner(GcodeFlavor flavor, const MachineLimits& limits) : flavor_(flavor), limits_(limits) {}

  /// One profile a move, valid until the next call. Cost: O(moves).
  std::span<const MoveProfile> Plan(std::span<const KinematicMove> moves);

 private:
  void PlanMarlin();
  void PlanKlipper();
  void LimitJunctionsForward();
  void LimitJunctionsBackward();
  double MarlinJunctionV2(const KinematicMove& before, const KinematicMove& move) const;

  GcodeFlavor flavor_;
  MachineLimits limits_;
  std::vector<KinematicMove> moves_;  ///< limited
  std::vector<double> entry_v2_;      ///< greatest; one more for the end
  // Klipper's, with the acceleration that minimum_cruise_ratio leaves:
  std::vector<double> calm_reach_v2_;
  std::vector<double> calm_entry_v2_;
  std::vector<double> peak_v2_;
  std::vector<MoveProfile> profiles_;
};

}  // namespace slicefarm::motion
