#include "services/motion/algo/toolpath/wipe.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/gcode/gcode_text.h"
#include "common/geometry/between.h"
#include "common/geometry/measure.h"
#include "common/model/options/motion_options.h"
#include "common/model/options/tool_row.h"
#include "services/motion/algo/toolpath/print_speed.h"
#include "services/motion/algo/toolpath/toolpath.h"
#include "services/motion/algo/toolpath/toolpath_builder.h"

namespace slicefarm::motion {
namespace {

constexpr double kLeastStepNm = 200'000;
/// Share of the full wipe length. A wipe above it counts as complete and retracts everything: steps
/// make wipes slightly shorter.
constexpr double kWholeWipe = 0.9;
/// Smallest speed of a wipe that has the speed of the bead before it.
constexpr double kLeastWipeMmS = 10;

/// Returns the points after the end of the path.
std::vector<Point> PathOn(const Path& path) {
  std::vector<Point> travel = path.points;
  if (path.closed) {
    travel.push_back(travel.front());
  } else {
    std::ranges::reverse(travel);
  }
  return travel;
}

/// Returns the points of a line, each shifted to the left of the line there.
std::vector<Point> ShiftedLeft(const std::vector<Point>& line, double shift_nm) {
  std::vector<Point> shifted;
  for (size_t i = 0; i < line.size(); ++i) {
    const Point from = line[i > 0 ? i - 1 : 0], to = line[std::min(i + 1, line.size() - 1)];
    const double length = Distance(from, to);
    const double scale = length > 0 ? shift_nm / length : 0;
    shifted.push_back(line[i] + Point{std::llround(-scale * static_cast<double>(to.y - from.y)),
                                      std::llround(scale * static_cast<double>(to.x - from.x))});
  }
  return shifted;
}

}  // namespace

Wipe WipeOf(const MotionOptions& options) {
  const RetractionOptions& retraction = options.tool().retraction;
  const double pulled_mm = retraction.length_mm * (1 - retraction.before_wipe);
  if (!retraction.wipe || retraction.length_mm <= 0 || retraction.speed_mm_s <= 0) return {};
  const double speed_mm_s = options.wipe_speed_ratio * TravelSpeed(options);
  if (retraction.wipe_distance_mm > 0) return {speed_mm_s, retraction.wipe_distance_mm};
  return {speed_mm_s, pulled_mm / retraction.speed_mm_s * speed_mm_s};
}

std::vector<PointUm> WipePath(const Path& path, double length_mm, double shift_nm) {
  const std::vector<Point> travel = PathOn(path);
  std::vector<Point> kept = {travel.front()};
  double left_nm = length_mm * static_cast<double>(kNmPerMm);
  Point last = travel.front();
  for (size_t i = 1; i < travel.size() && left_nm >= kLeastStepNm; ++i) {
    const double step_nm = Distance(last, travel[i]);
    if (step_nm < kLeastStepNm) continue;
    last = step_nm <= left_nm ? travel[i] : PointBetween(last, travel[i], left_nm / step_nm);
    left_nm -= step_nm;
    kept.push_back(last);
  }
  if (kept.size() == 1) return {};
  if (shift_nm == 0) {
    kept.erase(kept.begin());
  } else {
    kept = ShiftedLeft(kept, shift_nm);
  }
  std::vector<PointUm> points;
  for (const Point point : kept) points.push_back({ToUm(point.x), ToUm(point.y)});
  return points;
}

/// Returns the distance in nm to the left by which the wipe of a path is shifted; negative: to the
/// right.
double ToolpathBuilder::WipeShiftOf(const Path& path) const {
  const RegionMotion& region = options_.speeds[static_cast<size_t>(path.settings)];
  const bool shifts = region.wipe_inward && after_inner_ && path.closed &&
                      path.feature == Feature::kExternalPerimeter;
  if (!shifts) return 0;
  const auto width_nm = static_cast<double>(path.WidthAt(0));
  const double asked_nm = region.wipe_inward_nm > 0 ? static_cast<double>(region.wipe_inward_nm)
                                                    : region.wipe_inward_share * width_nm;
  return (options_.clockwise == reversed_ ? 1 : -1) * std::min(asked_nm, width_nm);
}

void ToolpathBuilder::Retract() {
  if (retracted_ || retract_units_ == 0) return;
  retracted_ = true;
  pulled_units_ = retract_units_;
  ++stats_.retractions;
  const int32_t before = UnitsBeforeWipe();
  PullBack(before);
  if (wipe_path_.empty()) return;
  const double share = options_.tool().retraction.after_wipe;
  const auto after =
      std::min(retract_units_ - before, static_cast<int32_t>(std::lround(share * retract_units_)));
  PullBack(retract_units_ - before - WipeBack(retract_units_ - before - after));
}

void ToolpathBuilder::PullBack(int32_t units) {
  if (units <= 0) return;
  at_.filament = -units;
  at_.feed_rate = FeedRate(options_.tool().retraction.speed_mm_s);
  Push(MoveKind::kRetract, accelerations_.Retract(set_acceleration_));
  path_.moves.back().if_needed = std::exchange(as_left_, false);
}

/// Returns the units (1e-5 mm) to retract before the wipe. If wipe_distance is set, the wipe may be
/// too short to retract the remaining units at the retraction speed; then more units are retracted
/// before it.
int32_t ToolpathBuilder::UnitsBeforeWipe() const {
  if (wipe_path_.empty()) return retract_units_;
  const RetractionOptions& retraction = options_.tool().retraction;
  const auto before = static_cast<int32_t>(std::lround(retraction.before_wipe * retract_units_));
  if (retraction.wipe_distance_mm <= 0) return before;
  const double most_mm = MovesMm(wipe_path_) / WipeSpeed() * retraction.speed_mm_s;
  const auto most = static_cast<int32_t>(std::lround(most_mm * kFilamentUnitsPerMm));
  return std::max(before, retract_units_ - most);
}

double ToolpathBuilder::WipeSpeed() const {
  if (!options_.wipe_as_printed || print_feed_rate_ <= 0) return wipe_.speed_mm_s;
  return std::max(kLeastWipeMmS, SpeedOf(print_feed_rate_));
}

/// Retracts `units` (1e-5 mm) during the wipe. If the path is much shorter than the wipe, retracts
/// only the corresponding share. Returns the retracted units.
int32_t ToolpathBuilder::WipeBack(int32_t units) {
  const double reach_mm = MovesMm(wipe_path_);
  const bool whole =
      reach_mm > kWholeWipe * wipe_.length_mm || options_.tool().retraction.wipe_distance_mm > 0;
  const double whole_mm = whole ? reach_mm : wipe_.length_mm;
  const int32_t feed_rate = FeedRate(WipeSpeed());
  int32_t pulled = 0;
  double gone_mm = 0;
  for (const PointUm place : wipe_path_) {
    gone_mm += MovesMm({&place, 1});
    const auto until = static_cast<int32_t>(std::lround(gone_mm / whole_mm * units));
    at_.x_um = place.x;
    at_.y_um = place.y;
    at_.filament = pulled - until;
    at_.feed_rate = feed_rate;
    Push(MoveKind::kWipe, accelerations_.Wipe(set_acceleration_));
    pulled = until;
  }
  return pulled;
}

void ToolpathBuilder::Restart() {
  if (!retracted_ && !as_left_) return;
  MoveZ(z_um_);
  retracted_ = false;
  const bool if_needed = std::exchange(as_left_, false);
  if (pulled_units_ == 0) return;
  at_.filament = pulled_units_ + extra_units_;
  at_.feed_rate = FeedRate(options_.tool().retraction.restart_speed_mm_s);
  if (!if_needed) filament_ += extra_units_;
  Push(MoveKind::kRestart, accelerations_.Retract(set_acceleration_));
  path_.moves.back().if_needed = if_needed;
}

}  // namespace slicefarm::motion
