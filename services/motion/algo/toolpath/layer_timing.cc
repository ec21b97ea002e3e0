#include "services/motion/algo/toolpath/layer_timing.h"

#include <cmath>

#include "services/motion/algo/gcode/gcode_text.h"
#include "services/motion/algo/toolpath/print_speed.h"

namespace slicefarm::motion {
namespace {

/// A move from where `before` ends.
KinematicMove ToKinematic(const Move& before, const Move& move) {
  const double x = static_cast<double>(move.x_um - before.x_um) / kUmPerMm;
  const double y = static_cast<double>(move.y_um - before.y_um) / kUmPerMm;
  const double z = static_cast<double>(move.z_um - before.z_um) / kUmPerMm;
  const double e = static_cast<double>(move.filament) / kFilamentUnitsPerMm;
  double length = std::sqrt(x * x + y * y + z * z);
  if (length == 0) length = std::abs(e);
  const double scale = 1 / length;
  return {length,
          {x * scale, y * scale, z * scale, e * scale},
          SpeedOf(move.feed_rate),
          move.acceleration_mm_s2};
}

}  // namespace

std::span<const double> LayerTiming::Times(const Toolpath& path) {
  times_.assign(path.moves.size(), 0);
  const size_t approach = std::min(path.approach, path.moves.size());
  PlanRun(path, 0, approach);
  PlanRun(path, approach + 1, path.moves.size());
  return times_;
}

void LayerTiming::PlanRun(const Toolpath& path, size_t first, size_t last) {
  if (first >= last) return;
  Move before = path.moves[first];
  before.z_um = path.start_z_um;
  if (first > 0) before = path.moves[first - 1];
  run_.clear();
  for (size_t i = first; i < last; ++i) {
    run_.push_back(ToKinematic(before, path.moves[i]));
    before = path.moves[i];
  }
  const auto profiles = planner_->Plan(run_);
  for (size_t i = first; i < last; ++i) times_[i] = profiles[i - first].time_s;
}

void AddTimes(const Toolpath& path, std::span<const double> times, size_t first,
              ProgramStats& stats) {
  for (size_t i = first; i < times.size(); ++i) {
    const Move& move = path.moves[i];
    if (move.kind == MoveKind::kPrint) {
      stats.features[static_cast<size_t>(move.feature)].time_s += times[i];
    } else {
      stats.travel_time_s += times[i];
    }
  }
}

}  // namespace slicefarm::motion
