#pragma once

#include <array>
#include <optional>
#include <span>

#include "common/model/options/tool_row.h"
#include "services/motion/algo/toolpath/layer_timing.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// Fan speeds in percent for walls over air, indexed by the degree of overhang: for a supported
/// width of 0, 25, 50 and 75 %.
using OverhangFans = std::array<double, kOverhangDegrees>;

/// Slows down the beads of a layer, all by the same factor, until the layer's program takes at
/// least slowdown_below_layer_time. The time is the planner's, with accelerations. No bead is
/// slowed below min_print_speed, and travels keep their speed.
///
/// With consistent_surface the inner beads are slowed down first. Surface beads are slowed down
/// only if the inner beads at min_print_speed are not enough. Surface beads are the two outermost
/// walls, and beads that end transition_mm or less before them.
///
/// `paths`: all toolpaths of `program`. Returns the new time in s of each move, valid until the
/// next call of LayerTiming::Times. Cost: O(moves) if the layer is slow enough, otherwise about ten
/// times as much.
std::span<const double> SlowDown(const CoolingOptions& cooling, std::span<const MoveSpan> program,
                                 LayerTiming& timing, std::span<Toolpath> paths);

/// Returns the fan speed in percent for a layer that takes `layer_time_s`. The speed is between
/// min_fan_speed and max_fan_speed, and is higher for a shorter layer. The fan is off in the first
/// layers, or has first_layer_fan_speed in the first one. Then its speed rises layer by layer up to
/// full_fan_speed_layer.
int32_t FanPercent(const CoolingOptions& cooling, int32_t layer_index, double layer_time_s);

/// Returns true if the fan is off before this layer for any times of layers.
bool IsOffBefore(const CoolingOptions& cooling, int32_t layer_index);

/// Returns the fan speed in percent for bridges and overhangs, at least `fan_percent`.
int32_t BridgeFanPercent(const CoolingOptions& cooling, int32_t layer_index, int32_t fan_percent);

/// Returns the largest supported share, in percent of the width, at which a wall still gets the fan
/// speed for bridges. Returns -1 if only bridges get this speed.
int32_t CooledRest(const CoolingOptions& cooling);

/// Fan speeds in percent for kinds of lines; -1: the fan speed of bridges for bridges over sparse
/// infill, otherwise the layer's fan speed.
struct LineFans {
  int32_t interface_percent = -1;  ///< support interfaces
  int32_t ironing_percent = -1;
  int32_t internal_bridge_percent = -1;  ///< bridges over sparse infill

  friend bool operator==(const LineFans&, const LineFans&) = default;
};

/// Returns the fan speeds for kinds of lines in a layer.
LineFans LineFanPercent(const CoolingOptions& cooling, int32_t layer_index);

/// Returns the fan speeds in percent for walls over air, each at least `fan_percent`. Returns
/// nullopt without enable_dynamic_fan_speeds.
std::optional<OverhangFans> OverhangFanPercent(const CoolingOptions& cooling, int32_t layer_index,
                                               int32_t fan_percent);

}  // namespace slicefarm::motion
