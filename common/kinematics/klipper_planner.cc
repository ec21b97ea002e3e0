#include "common/kinematics/klipper_planner.h"

#include <algorithm>

#include "common/kinematics/klipper_junction.h"
#include "common/kinematics/trapezoid.h"

namespace slicefarm {
namespace {

/// Special value of peak_v2: the move decelerates from start to end, and its peak is the peak of
/// the previous move.
constexpr double kAsBefore = -1;

}  // namespace

KinematicMove KlipperPlanner::Limited(const KinematicMove& move) const {
  return LimitedByKlipper(move, limits());
}

void KlipperPlanner::Add(const KinematicMove& asked) {
  Queued next;
  next.move = Limited(asked);
  const double calm = 1 - std::clamp(limits().minimum_cruise_ratio, 0.0, 1.0);
  next.calm_reach_v2 =
      2 * asked.length_mm * std::min(calm * asked.acceleration_mm_s2, next.move.acceleration_mm_s2);
  if (!queue_.empty()) {
    const Queued& before = queue_.back();
    next.entry_v2 =
        std::min(KlipperJunctionV2(before.move, next.move), before.entry_v2 + ReachV2(before.move));
    next.calm_entry_v2 = std::min(next.entry_v2, before.calm_entry_v2 + before.calm_reach_v2);
  }
  queue_.push_back(next);
}

std::span<const MoveProfile> KlipperPlanner::Stop() {
  LimitBackward();
  profiles_.resize(queue_.size());
  double before = 0;
  for (size_t i = 0; i < queue_.size(); ++i) {
    const Queued& at = queue_[i];
    const double exit_v2 = i + 1 < queue_.size() ? queue_[i + 1].entry_v2 : 0;
    const double cruise = at.peak_v2 == kAsBefore ? std::min(before, at.entry_v2) : at.peak_v2;
    profiles_[i] =
        Trapezoid(at.move, std::min(at.entry_v2, cruise), cruise, std::min(exit_v2, cruise));
    before = cruise;
  }
  queue_.clear();
  return profiles_;
}

void KlipperPlanner::LimitBackward() {
  double exit_v2 = 0, calm_exit_v2 = 0, peak = 0;
  bool waiting = false;  // later moves get their peak from this one
  for (size_t i = queue_.size(); i-- > 0;) {
    Queued& at = queue_[i];
    const double reachable = exit_v2 + ReachV2(at.move);
    const double calm_reachable = calm_exit_v2 + at.calm_reach_v2;
    at.entry_v2 = std::min(at.entry_v2, reachable);
    at.calm_entry_v2 = std::min(at.calm_entry_v2, calm_reachable);
    if (at.calm_entry_v2 == calm_reachable) {
      at.peak_v2 = kAsBefore;
      waiting = true;
    } else {
      if (waiting || at.calm_entry_v2 + at.calm_reach_v2 > calm_exit_v2)
        peak = (at.calm_entry_v2 + calm_reachable) / 2;
      waiting = false;
      const double top = at.move.speed_mm_s * at.move.speed_mm_s;
      at.peak_v2 = std::min({(at.entry_v2 + reachable) / 2, top, peak});
    }
    exit_v2 = at.entry_v2;
    calm_exit_v2 = at.calm_entry_v2;
  }
}

}  // namespace slicefarm
