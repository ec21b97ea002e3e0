#include "processes/mill/model/check_milling.h"

#include <fmt/core.h>

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "common/base/error.h"

namespace slicefarm {
namespace {

/// Numeric option with its allowed range, both ends included.
struct NumberRule {
  std::string_view setting;
  double got = 0;
  double least = 0;
  double most = 0;
};

absl::Status CheckNumbers(std::span<const NumberRule> rules) {
  for (const NumberRule& rule : rules) {
    if (rule.got >= rule.least && rule.got <= rule.most) continue;
    return MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
        fmt::format("{} must be from {} to {}, not {}", rule.setting, rule.least, rule.most,
                    rule.got),
        {{"setting", std::string(rule.setting)}, {"got", fmt::format("{}", rule.got)}});
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status CheckMillingOptions(const MillingOptions& options) {
  const MachiningOptions& machining = options.machining;
  const double diameter = 2 * options.cutter.radius_mm();
  return CheckNumbers(std::array{
      NumberRule{"cutter", diameter, 0.01, 500},
      NumberRule{"stepdown", options.stepdown_mm, 0.001, 1000},
      NumberRule{"stepover", options.stepover_share, 0.01, 0.5},
      NumberRule{"allowance", options.allowance_mm, 0, 100},
      NumberRule{"minimum_width", options.minimum_width_mm, 0, 1000},
      NumberRule{"finish_stepdown", options.finish_stepdown_mm, 0.001, 1000},
      NumberRule{"finish_stepover", options.finish_stepover_mm, 0.001, diameter},
      NumberRule{"rest_angle", options.rest_angle_deg, 0, 80},
      NumberRule{"sampling", options.sampling_mm, 0.001, 100},
      NumberRule{"tolerance", options.tolerance_mm, 0.002, 1},
      NumberRule{"stock_margin", options.stock_margin_mm, 0, 1000},
      NumberRule{"bottom", options.bottom_mm, 0, 1e4},
      NumberRule{"ramp_angle", machining.ramp_angle_deg, 0.1, 60},
      NumberRule{"helix_radius", machining.helix_radius_mm, 0, options.cutter.radius_mm()},
      NumberRule{"lead_in_radius", machining.lead_in_radius_mm, 0, 100},
      NumberRule{"safe_height", machining.safe_height_mm, 0.1, 1000},
      NumberRule{"clearance", machining.clearance_mm, 0.05, machining.safe_height_mm},
      NumberRule{"feed", machining.feed_mm_min, 0.1, 1e6},
      NumberRule{"plunge_feed", machining.plunge_feed_mm_min, 0.1, 1e6},
      NumberRule{"rapid", machining.rapid_mm_min, 0.1, 1e6},
      NumberRule{"spindle", static_cast<double>(machining.spindle_rpm), 1, 1e6},
      NumberRule{"tool_number", static_cast<double>(machining.tool_number), 0, 99'999},
      NumberRule{"tool_length", machining.tool_length_mm, 0, 1000},
      NumberRule{"machine_max_acceleration_x", machining.max_acceleration_mm_s2[0], 1, 1e6},
      NumberRule{"machine_max_acceleration_y", machining.max_acceleration_mm_s2[1], 1, 1e6},
      NumberRule{"machine_max_acceleration_z", machining.max_acceleration_mm_s2[2], 1, 1e6},
      NumberRule{"jerk_limit", machining.jerk_mm_s3, 1, 1e8},
  });
}

}  // namespace slicefarm
