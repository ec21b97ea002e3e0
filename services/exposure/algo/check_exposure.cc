#include "services/exposure/algo/check_exposure.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>

#include "common/base/error.h"

namespace slicefarm::exposure {
namespace {

constexpr double kMaxLengthNm = 2'100'000'000;
constexpr double kLeastDistanceNm = 1'000;
constexpr double kMaxContours = 1'000;
constexpr double kMaxSkinLayers = 1'000;
constexpr double kMaxPowerW = 1e6;
constexpr double kMaxSpeedMmS = 1e6;
constexpr double kMaxDelayUs = 1e9;
constexpr double kMaxAngleDeg = 36'000;

/// Keeps the first fault.
class Checker {
 public:
  void Within(const std::string& setting, double value, double least, double most) {
    if (!status_.ok() || (value >= least && value <= most)) return;
    status_ = MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                        fmt::format("{} is {}, must be {} to {}", setting, value, least, most),
                        {{"setting", setting}});
  }
  absl::Status Take() { return std::move(status_); }

 private:
  absl::Status status_;
};

void CheckStyle(const ExposureStyle& style, Checker& check) {
  check.Within("power_w", style.power_w, 0, kMaxPowerW);
  check.Within("speed_mm_s", style.speed_mm_s, 1e-3, kMaxSpeedMmS);
  check.Within("focus_mm", style.focus_mm, -1e4, 1e4);
  check.Within("frequency_khz", style.frequency_khz, 0, 1e9);
  check.Within("point_distance_nm", static_cast<double>(style.point_distance_nm), 0, kMaxLengthNm);
  check.Within("point_time_us", style.point_time_us, 0, kMaxDelayUs);
  check.Within("point_delay_us", style.point_delay_us, 0, kMaxDelayUs);
}

}  // namespace

absl::Status CheckExposure(const ExposureOptions& options) {
  Checker check;
  const auto length = [&](const char* name, Coord value, double least) {
    check.Within(name, static_cast<double>(value), least, kMaxLengthNm);
  };
  length("hatch_distance_nm", options.hatch_distance_nm, kLeastDistanceNm);
  check.Within("hatch_angle_deg", options.hatch_angle_deg, -kMaxAngleDeg, kMaxAngleDeg);
  check.Within("layer_rotation_deg", options.layer_rotation_deg, -kMaxAngleDeg, kMaxAngleDeg);
  length("minimum_vector_nm", options.minimum_vector_nm, 0);
  const auto wide = static_cast<double>(options.hatch_distance_nm);
  length("stripe_width_nm", options.stripe_width_nm, wide);
  length("island_width_nm", options.island_width_nm, wide);
  // Cells that reach into the next but one would be scanned thrice.
  check.Within("overlap_nm", static_cast<double>(options.overlap_nm), 0,
               static_cast<double>(std::min(options.stripe_width_nm, options.island_width_nm)) / 2);
  check.Within("ring_overlap_nm", static_cast<double>(options.ring_overlap_nm), 0, wide);
  length("spot_nm", options.spot_nm, 1);
  length("beam_compensation_nm", options.beam_compensation_nm, 0);
  check.Within("contours", options.contours, 0, kMaxContours);
  length("contour_distance_nm", options.contour_distance_nm, kLeastDistanceNm);
  length("hatch_offset_nm", options.hatch_offset_nm, 0);
  check.Within("upskin_layers", options.upskin_layers, 0, kMaxSkinLayers);
  check.Within("downskin_layers", options.downskin_layers, 0, kMaxSkinLayers);
  length("skin_overlap_nm", options.skin_overlap_nm, 0);
  length("skywriting_nm", options.skywriting_nm, 0);
  check.Within("jump_speed_mm_s", options.jump.speed_mm_s, 1e-3, kMaxSpeedMmS);
  check.Within("jump_delay_us", options.jump.delay_us, 0, kMaxDelayUs);
  check.Within("mark_delay_us", options.jump.mark_delay_us, 0, kMaxDelayUs);
  check.Within("polygon_delay_us", options.jump.polygon_delay_us, 0, kMaxDelayUs);
  for (const ExposureStyle& style : options.styles) CheckStyle(style, check);
  return check.Take();
}

}  // namespace slicefarm::exposure
