#include "services/motion/algo/toolpath/layer_timing.h"

#include "services/motion/algo/toolpath/edge_moves.h"

namespace slicefarm::motion {
namespace {

double FirstBeadsAcceleration(std::span<const Stretch> stretches) {
  for (const Stretch& stretch : stretches)
    for (size_t i = stretch.first; i < stretch.last; ++i)
      if (stretch.path->moves[i].kind == MoveKind::kPrint)
        return stretch.path->moves[i].acceleration_mm_s2;
  return 0;
}

}  // namespace

std::span<const double> LayerTiming::Times(std::span<const Stretch> stretches) {
  times_.clear();
  if (stretches.empty()) return times_;
  const Toolpath& first = *stretches.front().path;
  MoveWalk walk({.z_um = first.start_z_um}, FirstBeadsAcceleration(stretches));
  for (const Stretch& stretch : stretches) {
    for (size_t i = stretch.first; i < stretch.last; ++i) {
      const EdgeMove before = walk.at();
      const EdgeMove& move = walk.Go(stretch.path->moves[i], stretch.shift);
      times_.push_back(0);
      if (&stretch == &stretches.front() && i == first.approach) {
        PlanRun();
      } else if (const auto kinematic = ToKinematic(before, move, 0)) {
        planner_->Add(*kinematic);
        run_.push_back(times_.size() - 1);
      }
    }
  }
  PlanRun();
  return times_;
}

void LayerTiming::PlanRun() {
  const auto profiles = planner_->Stop();
  for (size_t i = 0; i < run_.size(); ++i) times_[run_[i]] = profiles[i].time_s;
  run_.clear();
}

void AddTimes(std::span<const Stretch> stretches, std::span<const double> times,
              ProgramStats& stats) {
  auto time = times.begin();
  for (const Stretch& stretch : stretches) {
    for (size_t i = stretch.first; i < stretch.last; ++i, ++time) {
      const Move& move = stretch.path->moves[i];
      if (move.kind == MoveKind::kPrint) {
        stats.features[static_cast<size_t>(move.feature)].time_s += *time;
        continue;
      }
      stats.travel_time_s += *time;
      if (move.kind == MoveKind::kRetract || move.kind == MoveKind::kRestart)
        stats.retract_time_s += *time;
    }
  }
}

}  // namespace slicefarm::motion
