#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/model/layer.h"
#include "common/model/motion_options.h"
#include "services/motion/algo/firmware/firmware.h"
#include "services/motion/algo/kinematics/planner.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// The time that a layer's moves take, by the planner of the firmware. The approach to the layer is
/// left out: where it begins is not known.
class LayerTiming {
 public:
  LayerTiming(const Firmware& firmware, const MachineLimits& limits)
      : planner_(firmware.MakePlanner(limits)) {}

  /// Time in s of each move of `path`, 0 for the approach; valid until the next call. Cost:
  /// O(moves).
  std::span<const double> Times(const Toolpath& path);

 private:
  void PlanRun(const Toolpath& path, size_t first, size_t last);

  std::unique_ptr<Planner> planner_;
  std::vector<KinematicMove> run_;
  std::vector<double> times_;
};

/// Adds the times of the moves from `first` on up: those of beads by feature, all others as travel.
void AddTimes(const Toolpath& path, std::span<const double> times, size_t first,
              ProgramStats& stats);

}  // namespace slicefarm::motion
