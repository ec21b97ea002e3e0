#include "services/motion/algo/toolpath/print_speed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/model/options/motion_options.h"
#include "common/model/options/region_motion.h"
#include "services/motion/algo/toolpath/feature_groups.h"
#include "services/motion/algo/toolpath/overhang.h"

namespace slicefarm::motion {
namespace {

/// Speed in mm/s if neither settings nor machine limits give one.
constexpr double kDefaultSpeedMmS = 60;
constexpr double kMaxFeedRate = 1e6;

bool IsSmallWall(const Path& path, double length_mm, double radius_mm) {
  return length_mm <= 2 * std::numbers::pi * radius_mm &&
         (path.feature == Feature::kExternalPerimeter || path.feature == Feature::kPerimeter);
}

bool IsSmallSupport(const Path& path, double length_mm, double radius_mm) {
  return path.closed && length_mm <= 2 * std::numbers::pi * radius_mm &&
         (path.feature == Feature::kSupport || path.feature == Feature::kSupportInterface);
}

}  // namespace

PrintSpeeds::PrintSpeeds(const MotionOptions& options, Ground ground, int32_t layer)
    : options_(options), ground_(ground), layer_(layer) {
  if (options.tool().flow_fit.empty()) return;
  if (const auto fit = FlowFit::Parse(options.tool().flow_fit); fit.ok()) fit_ = *fit;
}

double PrintSpeeds::Of(const Path& path, double length_mm) const {
  const RegionMotion& region = options_.speeds[static_cast<size_t>(path.settings)];
  if (path.feature == Feature::kSkirt && region.skirt_speed_mm_s > 0)
    return region.skirt_speed_mm_s;
  double speed = region.speed_mm_s[static_cast<size_t>(path.feature)];
  if (path.feature == Feature::kInternalBridge && speed <= 0)
    speed = region.speed_mm_s[static_cast<size_t>(Feature::kBridgeInfill)];
  if (IsSmallWall(path, length_mm, region.small_perimeter_radius_mm) &&
      region.small_perimeter_speed_mm_s > 0) {
    speed = region.small_perimeter_speed_mm_s;
  }
  if (IsSmallSupport(path, length_mm, region.small_support_radius_mm))
    speed = region.small_support_mm_s > 0 ? region.small_support_mm_s
                                          : region.small_support_ratio * speed;
  speed = OnGround(ground_, path.feature, speed);
  if (speed <= 0)
    speed = options_.max_print_speed_mm_s > 0 ? options_.max_print_speed_mm_s : kDefaultSpeedMmS;
  return InFirstLayers(path.feature, speed);
}

/// Returns the speed in a layer below slow_down_layers: it rises evenly from the first layer's
/// speed. For all beads except walls, the first layer's speed is that of its infill.
double PrintSpeeds::InFirstLayers(Feature feature, double speed) const {
  if (ground_ != Ground::kLayers || layer_ >= options_.slow_down_layers) return speed;
  const double first =
      OnGround(Ground::kBed, IsWall(feature) ? feature : Feature::kSolidInfill, speed);
  if (first >= speed) return speed;
  return first + (speed - first) * layer_ / options_.slow_down_layers;
}

double PrintSpeeds::OnGround(Ground ground, Feature feature, double speed) const {
  const auto either = [speed](double own_mm_s, double ratio) {
    return own_mm_s > 0 ? own_mm_s : speed * ratio;
  };
  switch (ground) {
    case Ground::kBed:
      if (feature == Feature::kSolidInfill && options_.first_layer_infill_speed_mm_s > 0)
        return options_.first_layer_infill_speed_mm_s;
      return either(options_.first_layer_speed_mm_s, options_.first_layer_speed_ratio);
    case Ground::kRaft:
      return either(options_.over_raft_speed_mm_s, options_.over_raft_speed_ratio);
    case Ground::kLayers:
      break;
  }
  return speed;
}

double PrintSpeeds::OverAir(const Path& path, double speed_mm_s, uint8_t rest) const {
  const RegionMotion& region = options_.speeds[static_cast<size_t>(path.settings)];
  if (!region.dynamic_overhangs || rest == kFullRest) return speed_mm_s;
  std::array<double, kOverhangDegrees> speeds = region.overhang_speed_mm_s;
  for (double& speed : speeds)
    if (speed <= 0) speed = speed_mm_s;
  return std::min(speed_mm_s, ByRest(speeds, speed_mm_s, rest));
}

double PrintSpeeds::LargestFlow(Coord width_nm, Coord height_nm) const {
  const double most = options_.tool().max_volumetric_speed_mm3_s;
  const double fixed = most > 0 ? most : std::numeric_limits<double>::infinity();
  if (!fit_) return fixed;
  return std::min(fixed, fit_->At(ToMm(height_nm), ToMm(width_nm)));
}

double PrintSpeeds::LimitedByFlow(double speed_mm_s, double section_mm2, double largest_mm3_s) {
  if (section_mm2 <= 0) return speed_mm_s;
  return std::min(speed_mm_s, largest_mm3_s / section_mm2);
}

double PrintSpeeds::OutsideResonance(Feature feature, double speed_mm_s) const {
  const ResonanceOptions& resonance = options_.resonance;
  if (!resonance.avoid || feature != Feature::kExternalPerimeter) return speed_mm_s;
  const bool inside = resonance.from_mm_s < speed_mm_s && speed_mm_s <= resonance.until_mm_s;
  return inside ? resonance.from_mm_s : speed_mm_s;
}

int32_t PrintSpeeds::WithinFlow(int32_t feed_rate, double section_mm2, double largest_mm3_s) {
  const double fastest = 60 * LimitedByFlow(kMaxFeedRate, section_mm2, largest_mm3_s);
  // Tolerance of the flow limit. Without it, speeds in whole mm/min would alternate.
  constexpr double kSlack = 1.001;
  if (feed_rate <= kSlack * fastest) return feed_rate;
  return std::max(1, static_cast<int32_t>(fastest));
}

double TravelSpeed(const MotionOptions& options, bool first_layer) {
  if (first_layer && options.first_layer_travel_speed_mm_s > 0)
    return options.first_layer_travel_speed_mm_s;
  return options.travel_speed_mm_s > 0 ? options.travel_speed_mm_s : kDefaultSpeedMmS;
}

double TravelSpeedZ(const MotionOptions& options) {
  if (options.travel_speed_z_mm_s > 0) return options.travel_speed_z_mm_s;
  const double limit = options.limits.max_feedrate_mm_s[2];
  return limit > 0 ? limit : TravelSpeed(options);
}

double FilamentAreaMm2(const MotionOptions& options) {
  const double diameter_mm = options.tool().filament_diameter_mm;
  return std::numbers::pi / 4 * diameter_mm * diameter_mm;
}

int32_t FeedRate(double speed_mm_s) {
  return static_cast<int32_t>(std::lround(std::clamp(speed_mm_s * 60, 1.0, kMaxFeedRate)));
}

}  // namespace slicefarm::motion
