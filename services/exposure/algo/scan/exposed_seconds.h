#pragma once

#include "common/geometry/measure.h"

namespace slicefarm {
struct ExposureStyle;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Returns the time in seconds for which the laser is on per mm of a vector, without effects of its
/// ends.
inline double LaserOnSecondsPerMm(const ExposureStyle& style) {
  if (style.point_distance_nm <= 0) return 1 / style.speed_mm_s;
  return style.point_time_us * 1e-6 / ToMm(static_cast<double>(style.point_distance_nm));
}

}  // namespace slicefarm::exposure
