#include "services/motion/algo/toolpath/print_speed.h"

#include <algorithm>
#include <cmath>

namespace slicefarm::motion {
namespace {

/// Where neither the settings nor the machine give a limit.
constexpr double kDefaultSpeedMmS = 60;
constexpr double kMaxFeedRate = 1e6;

/// A loop, also one that lost its end to the link that leads on from it.
bool IsLoop(const Path& path) {
  return path.closed ||
         (path.points.size() > 2 && Distance(path.points.front(), path.points.back()) <=
                                        static_cast<double>(path.WidthAt(0)));
}

bool IsSmallLoop(const Path& path, double length_mm) {
  return length_mm <= kSmallLoopMm && IsLoop(path) &&
         (path.feature == Feature::kExternalPerimeter || path.feature == Feature::kPerimeter);
}

}  // namespace

double PrintSpeeds::Of(const Path& path, double length_mm) const {
  const RegionSpeeds& region = options_.speeds[static_cast<size_t>(path.settings)];
  double speed = region.speed_mm_s[static_cast<size_t>(path.feature)];
  if (IsSmallLoop(path, length_mm) && region.small_perimeter_speed_mm_s > 0) {
    speed = region.small_perimeter_speed_mm_s;
  }
  if (first_layer_) {
    speed = options_.first_layer_speed_mm_s > 0 ? options_.first_layer_speed_mm_s
                                                : speed * options_.first_layer_speed_ratio;
  }
  if (speed > 0) return speed;
  return options_.max_print_speed_mm_s > 0 ? options_.max_print_speed_mm_s : kDefaultSpeedMmS;
}

double PrintSpeeds::LimitedByFlow(double speed_mm_s, double section_mm2) const {
  const double most = options_.max_volumetric_speed_mm3_s;
  if (most <= 0 || section_mm2 <= 0) return speed_mm_s;
  return std::min(speed_mm_s, most / section_mm2);
}

double TravelSpeed(const MotionOptions& options) {
  return options.travel_speed_mm_s > 0 ? options.travel_speed_mm_s : kDefaultSpeedMmS;
}

double TravelSpeedZ(const MotionOptions& options) {
  if (options.travel_speed_z_mm_s > 0) return options.travel_speed_z_mm_s;
  const double limit = options.limits.max_feedrate_mm_s[2];
  return limit > 0 ? limit : TravelSpeed(options);
}

int32_t FeedRate(double speed_mm_s) {
  return static_cast<int32_t>(std::lround(std::clamp(speed_mm_s * 60, 1.0, kMaxFeedRate)));
}

}  // namespace slicefarm::motion
