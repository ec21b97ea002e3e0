#include "services/motion/algo/toolpath/wipe.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/between.h"
#include "common/geometry/measure.h"
#include "common/model/options/motion_options.h"
#include "common/model/options/tool_row.h"
#include "services/motion/algo/toolpath/print_speed.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {
namespace {

constexpr double kSpeedShare = 0.8;
constexpr double kLeastStepNm = 200'000;

/// Returns the points after the end of the path.
std::vector<Point> WayOn(const Path& path) {
  std::vector<Point> way = path.points;
  if (path.closed) {
    way.push_back(way.front());
  } else {
    std::ranges::reverse(way);
  }
  return way;
}

}  // namespace

Wipe WipeOf(const MotionOptions& options) {
  const RetractionOptions& retraction = options.tool().retraction;
  const double pulled_mm = retraction.length_mm * (1 - retraction.before_wipe);
  if (!retraction.wipe || pulled_mm <= 0 || retraction.speed_mm_s <= 0) return {};
  const double speed_mm_s = kSpeedShare * TravelSpeed(options);
  return {speed_mm_s, pulled_mm / retraction.speed_mm_s * speed_mm_s};
}

std::vector<PlaceUm> WipeWay(const Path& path, double length_mm) {
  const std::vector<Point> way = WayOn(path);
  std::vector<PlaceUm> places;
  const auto add = [&](Point place) { places.push_back({ToUm(place.x), ToUm(place.y)}); };
  double left_nm = length_mm * static_cast<double>(kNmPerMm);
  Point last = way.front();
  for (size_t i = 1; i < way.size() && left_nm >= kLeastStepNm; ++i) {
    const double step_nm = Distance(last, way[i]);
    if (step_nm < kLeastStepNm) continue;
    last = step_nm <= left_nm ? way[i] : PointBetween(last, way[i], left_nm / step_nm);
    left_nm -= step_nm;
    add(last);
  }
  return places;
}

}  // namespace slicefarm::motion
