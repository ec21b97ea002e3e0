#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/kinematics/planner.h"
#include "common/model/layers/layer.h"
#include "services/motion/algo/firmware/firmware.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// Computes the time of a layer's moves with the firmware's planner. The firmware must outlive this
/// object. The travel to the first entry counts as 0 s, because its start is not known. Moves
/// before the first bead use the acceleration of the first bead, because their own is not known.
/// The computation for the whole print corrects both (print_clock.h).
class LayerTiming {
 public:
  LayerTiming(const Firmware& firmware, const MachineLimits& limits)
      : firmware_(firmware), planner_(firmware.MakePlanner(limits)) {}

  /// Returns the time in s of each move of the spans, in their order. The travel to the first
  /// entry and moves without a distance have 0. The last move of an arc has the time of the whole
  /// arc, which is computed from the firmware's chords; the arc's other moves have 0. Valid until
  /// the next call. Cost: O(moves and chords).
  std::span<const double> Times(std::span<const MoveSpan> spans);

 private:
  void Queue(const KinematicMove& move, double jerk_mm_s, size_t place);
  void QueueArc(const EdgeMove& from, const EdgeMove& to, const MoveArc& arc, int64_t filament);
  void PlanRun();

  const Firmware& firmware_;
  std::unique_ptr<Planner> planner_;
  std::vector<size_t> run_;  ///< indices in times_ of the moves in the planner
  std::vector<double> times_;
};

/// Adds the times of the spans' moves to the totals: beads per feature, all other moves as
/// travel.
void AddTimes(std::span<const MoveSpan> spans, std::span<const double> times, ProgramStats& stats);

/// Adds to the totals of a copy, which are sorted by copy. Inserts the copy if it is new.
void AddUse(int32_t copy, const FeatureUse& use, std::vector<CopyUse>& copies);

/// Adds the times of the spans' moves to the copies to which the moves belong.
void AddCopyTimes(std::span<const MoveSpan> spans, std::span<const double> times,
                  std::vector<CopyUse>& copies);

}  // namespace slicefarm::motion
