#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/kinematics/planner.h"
#include "common/model/layers/layer.h"
#include "services/motion/algo/firmware/firmware.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// The time that a layer's moves take, by the planner of the firmware, which must outlive this. The
/// way to the first entry
/// is left out: where it begins is not known. What runs with the acceleration of the layer before
/// runs as the layer's first bead. Both are put right where the print is put together
/// (print_clock.h).
class LayerTiming {
 public:
  LayerTiming(const Firmware& firmware, const MachineLimits& limits)
      : firmware_(firmware), planner_(firmware.MakePlanner(limits)) {}

  /// Time in s of each move of the stretches, in their order: 0 for the first approach and for
  /// moves that are there already; that of an arc, in the firmware's chords, is its last move's.
  /// Valid until the next call. Cost: O(moves and chords).
  std::span<const double> Times(std::span<const Stretch> stretches);

 private:
  void Queue(const KinematicMove& move, size_t place);
  void QueueArc(const EdgeMove& from, const EdgeMove& to, const MoveArc& arc, int64_t filament);
  void PlanRun();

  const Firmware& firmware_;
  std::unique_ptr<Planner> planner_;
  std::vector<size_t> run_;  ///< of the moves in the planner: places in times_
  std::vector<double> times_;
};

/// Adds the times of the stretches' moves: those of beads by feature, all others as travel.
void AddTimes(std::span<const Stretch> stretches, std::span<const double> times,
              ProgramStats& stats);

}  // namespace slicefarm::motion
