#include "services/motion/algo/input_check.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/model/layers/region_check.h"
#include "common/model/limits.h"
#include "common/model/options/motion_options.h"
#include "common/model/options/region_motion.h"
#include "common/model/options/tool_row.h"

namespace slicefarm::motion {
namespace {

constexpr Coord kMaxBeadNm = 100 * kNmPerMm;
/// Largest accepted length. In a move, lengths are 32-bit micrometres and 32-bit counts of 1e-5 mm
/// of filament; the sum of two lengths must fit.
constexpr double kMaxLengthMm = 1e4;
constexpr double kMaxSetting = 1e9;

struct Named {
  const char* setting;
  double value;
  double most = kMaxSetting;
};

absl::Status OutOfRange(const Named& named) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   std::string(named.setting) + " is " + std::to_string(named.value),
                   {{"setting", named.setting}, {"got", std::to_string(named.value)}});
}

bool InBounds(double value, double most = kMaxSetting) {
  return std::isfinite(value) && std::abs(value) <= most;
}

bool InBounds(Point point) {
  return std::abs(point.x) <= limits::kMaxCoord && std::abs(point.y) <= limits::kMaxCoord;
}

bool InBounds(const std::vector<Point>& points) {
  return std::ranges::all_of(points, [](Point p) { return InBounds(p); });
}

bool InBounds(const Path& path) {
  const auto is_width = [](Coord width) { return 0 <= width && width <= kMaxBeadNm; };
  return WellFormed(path) && std::all_of(path.widths_nm.begin(), path.widths_nm.end(), is_width) &&
         InBounds(path.points) && static_cast<int>(path.feature) < kFeatureCount;
}

bool InBounds(const PathBlock& block) {
  const auto has_bounds = [](const Travel& travel) { return InBounds(travel.corners); };
  const bool leaves_in_bounds = !block.exit_travel || (InBounds(block.exit_travel->to) &&
                                                       has_bounds(block.exit_travel->travel));
  const bool turns_in_bounds = !block.spiral || (InBounds(block.spiral->start) &&
                                                 InBounds(block.spiral->from.value_or(Point{})));
  return turns_in_bounds && 0 <= block.height_nm && block.height_nm <= kMaxBeadNm &&
         !block.paths.empty() &&
         (block.travels.empty() || block.travels.size() == block.paths.size()) &&
         leaves_in_bounds && std::ranges::all_of(block.travels, has_bounds) &&
         std::ranges::all_of(block.paths, [](const Path& path) { return InBounds(path); });
}

bool AreInOrder(const OrderedLayer& layer) {
  const auto is_shift = [](Coord nm) { return nm % 1000 == 0; };
  int32_t pass = 0;
  for (const BlockVisit& visit : layer.visits) {
    if (visit.block < 0 || visit.block >= std::ssize(layer.blocks)) return false;
    if (!InBounds(visit.shift) || !is_shift(visit.shift.x) || !is_shift(visit.shift.y))
      return false;
    if (visit.pass < pass || !InBounds(visit.corners)) return false;
    pass = visit.pass;
  }
  return true;
}

/// Returns true if begins_ready and ends_ready are possible. A block is built once for all its
/// visits, so it cannot be first in some passes and not first in others. The only block of a layer
/// is the first one of all passes.
bool CanBeReady(const OrderedLayer& layer) {
  if (!layer.begins_ready && !layer.ends_ready) return true;
  const bool only_block = layer.blocks.size() == 1 && layer.blocks.front().spiral;
  std::vector<int32_t> blocks;
  for (const BlockVisit& visit : layer.visits)
    blocks.push_back(only_block ? visit.pass : visit.block);
  std::ranges::sort(blocks);
  return std::ranges::adjacent_find(blocks) == blocks.end();
}

absl::Status CheckRegions(const OrderedLayer& layer, size_t rows) {
  for (const PathBlock& block : layer.blocks)
    for (const Path& path : block.paths)
      if (absl::Status ok = CheckRegion(path.settings, path.tool, rows, layer.frame); !ok.ok())
        return ok;
  return absl::OkStatus();
}

}  // namespace

absl::Status CheckOptions(const MotionOptions& options) {
  const RetractionOptions& retraction = options.tool().retraction;
  const CoolingOptions& cooling = options.tool().cooling;
  for (const Named& named :
       {Named{"max_volumetric_extrusion_rate_slope_segment_length", options.flow_segment_mm},
        Named{"filament_diameter", options.tool().filament_diameter_mm, kMaxLengthMm},
        Named{"extrusion_multiplier", options.tool().extrusion_multiplier}}) {
    if (!(named.value > 0 && InBounds(named.value, named.most))) return OutOfRange(named);
  }
  for (const Named& named :
       {Named{"retract_length", retraction.length_mm, kMaxLengthMm},
        Named{"retract_speed", retraction.speed_mm_s},
        Named{"deretract_speed", retraction.restart_speed_mm_s},
        Named{"retract_lift", retraction.lift_mm, kMaxLengthMm},
        Named{"retract_lift_above", retraction.lift_above_mm, kMaxLengthMm},
        Named{"retract_lift_below", retraction.lift_below_mm, kMaxLengthMm},
        Named{"travel_max_lift", retraction.ramp_lift_mm, kMaxLengthMm},
        Named{"travel_slope", retraction.ramp_slope_deg, 90},
        Named{"seam_gap_distance", options.seam_gap_mm, kMaxLengthMm},
        Named{"travel_short_distance_acceleration", options.short_travel_acceleration_mm_s2},
        Named{"first_layer_travel_acceleration", options.first_layer_travel_acceleration_mm_s2},
        Named{"accel_to_decel", options.accel_to_decel},
        Named{"default_jerk", options.jerk.default_mm_s},
        Named{"first_layer_jerk", options.jerk.first_layer_mm_s},
        Named{"travel_jerk", options.jerk.travel_mm_s},
        Named{"first_layer_travel_jerk", options.jerk.first_layer_travel_mm_s},
        Named{"fan_speedup_time", options.fan_speedup_s},
        Named{"fan_kickstart", options.fan_kickstart_s},
        Named{"part_cooling_fan_min_pwm", static_cast<double>(options.fan_least_percent), 100},
        Named{"min_resonance_avoidance_speed", options.resonance.from_mm_s},
        Named{"max_resonance_avoidance_speed", options.resonance.until_mm_s},
        Named{"spiral_vase_starting_flow_ratio", options.spiral.start_flow, 1},
        Named{"spiral_vase_finishing_flow_ratio", options.spiral.end_flow, 1},
        Named{"default_junction_deviation", options.jerk.junction_deviation_mm},
        Named{"cooling_perimeter_transition_distance", cooling.transition_mm},
        Named{"retract_before_wipe", retraction.before_wipe, 1},
        Named{"wipe_distance", retraction.wipe_distance_mm, kMaxLengthMm},
        Named{"wipe_speed", options.wipe_speed_ratio},
        Named{"slow_down_layers", static_cast<double>(options.slow_down_layers)},
        Named{"retract_before_travel", retraction.min_travel_mm, kMaxLengthMm},
        Named{"slowdown_below_layer_time", cooling.slowdown_below_layer_time_s},
        Named{"fan_below_layer_time", cooling.fan_below_layer_time_s},
        Named{"min_print_speed", cooling.min_print_speed_mm_s}}) {
    if (!(named.value >= 0 && InBounds(named.value, named.most))) return OutOfRange(named);
  }
  for (const RegionMotion& region : options.speeds)
    if (const Named flow{"bridge_flow_ratio", region.bridge_flow, 100};
        !(flow.value > 0 && InBounds(flow.value, flow.most)))
      return OutOfRange(flow);
  for (const RegionMotion& region : options.speeds)
    if (const Named width{"bridge_line_width", region.bridge_width_mm, kMaxLengthMm};
        !(width.value >= 0 && InBounds(width.value, width.most)))
      return OutOfRange(width);
  for (const Named& named :
       {Named{"retract_restart_extra", retraction.restart_extra_mm, kMaxLengthMm},
        Named{"z_offset", options.z_offset_mm, kMaxLengthMm}}) {
    if (!InBounds(named.value, named.most)) return OutOfRange(named);
  }
  return absl::OkStatus();
}

absl::Status CheckLayer(const OrderedLayer& layer, const MotionOptions& options) {
  const LayerFrame& frame = layer.frame;
  const bool good =
      std::abs(frame.print_z_nm) <= limits::kMaxCoord && 0 <= frame.height_nm &&
      frame.height_nm <= kMaxBeadNm &&
      std::ranges::all_of(layer.blocks, [](const PathBlock& block) { return InBounds(block); }) &&
      AreInOrder(layer) && CanBeReady(layer);
  if (good) return CheckRegions(layer, options.speeds.size());
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
      "layer " + std::to_string(frame.index) + ": a path or the layer itself is out of all bounds",
      {{"layer", std::to_string(frame.index)}});
}

}  // namespace slicefarm::motion
