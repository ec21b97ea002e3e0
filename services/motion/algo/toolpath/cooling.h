#pragma once

#include <array>
#include <optional>
#include <span>

#include "common/model/options/tool_row.h"
#include "services/motion/algo/toolpath/layer_timing.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// Fans in percent where 0, 25, 50 and 75 % of a wall rest on the layer below.
using OverhangFans = std::array<double, kOverhangDegrees>;

/// Slows the beads of a layer down, all by the same share, until its program takes
/// slowdown_below_layer_time as the planner reckons, accelerations included; but none below
/// min_print_speed. Travels keep their speed. With consistent_surface, the two outermost walls, and
/// beads that end transition_mm or less before them, are slowed down only if all others at
/// min_print_speed do not take long enough. `paths`: all that `program` is made of. Returns the
/// time in s of each of its moves as they are then; valid as LayerTiming::Times. Cost: O(moves) if
/// the layer is slow enough, else about ten times as much.
std::span<const double> SlowDown(const CoolingOptions& cooling, std::span<const Stretch> program,
                                 LayerTiming& timing, std::span<Toolpath> paths);

/// Fan in percent for a layer that takes `layer_time_s`: off for the first layers, then growing up
/// to full_fan_speed_layer; between the settings' bounds, the more the shorter the layer.
int32_t FanPercent(const CoolingOptions& cooling, int32_t layer_index, double layer_time_s);

/// The same for bridges and overhangs.
int32_t BridgeFanPercent(const CoolingOptions& cooling, int32_t layer_index, int32_t fan_percent);

/// The same for walls over air, by degree, never less than `fan_percent`; nothing if that is not
/// asked for.
std::optional<OverhangFans> OverhangFanPercent(const CoolingOptions& cooling, int32_t layer_index,
                                               int32_t fan_percent);

}  // namespace slicefarm::motion
