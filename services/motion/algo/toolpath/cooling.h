#pragma once

#include <span>
#include <vector>

#include "common/model/motion_options.h"
#include "services/motion/algo/toolpath/layer_timing.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// A toolpath, how often the layer has it, and how long its moves take.
struct TimedToolpath {
  Toolpath path;
  int copies = 1;
  std::vector<double> times_s = {};  ///< one a move

  /// All moves, or those after the approach alone: copies after the first are at their height.
  double TimeS() const;
  double TimeAfterApproachS() const;
};

/// Slows the beads of a layer down, all by the same share, until it takes slowdown_below_layer_time
/// as the planner reckons, accelerations included; but none below min_print_speed. Travels keep
/// their speed. The layer takes the first toolpath's moves, those of all other copies after their
/// approach, and `between_s`. Leaves the times of all moves as they are then.
/// Cost: O(moves) if the layer is slow enough, else about ten times as much.
void SlowDown(const CoolingOptions& cooling, double between_s, LayerTiming& timing,
              std::span<TimedToolpath> paths);

/// Fan in percent for a layer that takes `layer_time_s`: off for the first layers; else between the
/// settings' bounds, the more the shorter the layer.
int32_t FanPercent(const CoolingOptions& cooling, int32_t layer_index, double layer_time_s);

/// The same for bridges and overhangs.
int32_t BridgeFanPercent(const CoolingOptions& cooling, int32_t layer_index, int32_t fan_percent);

}  // namespace slicefarm::motion
