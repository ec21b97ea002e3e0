#include "services/motion/algo/kinematics/planner.h"

#include <algorithm>
#include <cmath>

#include "services/motion/algo/kinematics/klipper_junction.h"
#include "services/motion/algo/kinematics/marlin_junction.h"
#include "services/motion/algo/kinematics/trapezoid.h"

namespace slicefarm::motion {
namespace {

/// How much the squared speed can change over a move.
double ReachV2(const KinematicMove& move) { return 2 * move.length_mm * move.acceleration_mm_s2; }

double Squared(double v) { return v * v; }

/// Among the peaks: the move slows down from end to end, and takes the peak of the move before.
constexpr double kAsBefore = -1;

}  // namespace

KinematicMove LimitedByFirmware(const KinematicMove& move, GcodeFlavor flavor,
                                const MachineLimits& limits) {
  return flavor == GcodeFlavor::kKlipper ? LimitedByKlipper(move, limits)
                                         : LimitedByMarlin(move, limits);
}

std::span<const MoveProfile> Planner::Plan(std::span<const KinematicMove> moves) {
  moves_.resize(moves.size());
  entry_v2_.resize(moves.size() + 1);
  profiles_.resize(moves.size());
  if (moves.empty()) return profiles_;
  for (size_t i = 0; i < moves.size(); ++i) {
    moves_[i] = LimitedByFirmware(moves[i], flavor_, limits_);
  }
  if (flavor_ == GcodeFlavor::kKlipper) {
    const double calm = 1 - std::clamp(limits_.minimum_cruise_ratio, 0.0, 1.0);
    calm_reach_v2_.resize(moves.size());
    calm_entry_v2_.resize(moves.size() + 1);
    peak_v2_.resize(moves.size());
    for (size_t i = 0; i < moves.size(); ++i) {
      const double asked = calm * moves[i].acceleration_mm_s2;
      calm_reach_v2_[i] = 2 * moves[i].length_mm * std::min(asked, moves_[i].acceleration_mm_s2);
    }
    PlanKlipper();
  } else {
    PlanMarlin();
  }
  return profiles_;
}

double Planner::MarlinJunctionV2(const KinematicMove& before, const KinematicMove& move) const {
  if (limits_.junction_deviation_mm > 0) return JunctionDeviationV2(before, move, limits_);
  return Squared(ClassicJerkSpeed(before, move, limits_));
}

void Planner::PlanMarlin() {
  const bool jerk = limits_.junction_deviation_mm <= 0;
  entry_v2_[0] = jerk ? Squared(SafeSpeed(moves_[0], limits_)) : 0;
  for (size_t i = 1; i < moves_.size(); ++i) {
    entry_v2_[i] = MarlinJunctionV2(moves_[i - 1], moves_[i]);
  }
  entry_v2_[moves_.size()] = Squared(kMarlinRestMmS);
  for (size_t i = moves_.size(); i-- > 0;) {
    entry_v2_[i] = std::min(entry_v2_[i], entry_v2_[i + 1] + ReachV2(moves_[i]));
  }
  for (size_t i = 0; i < moves_.size(); ++i) {
    entry_v2_[i + 1] = std::min(entry_v2_[i + 1], entry_v2_[i] + ReachV2(moves_[i]));
    profiles_[i] =
        Trapezoid(moves_[i], entry_v2_[i], Squared(moves_[i].speed_mm_s), entry_v2_[i + 1]);
  }
}

void Planner::PlanKlipper() {
  LimitJunctionsForward();
  LimitJunctionsBackward();
  double before = 0;
  for (size_t i = 0; i < moves_.size(); ++i) {
    const double cruise = peak_v2_[i] == kAsBefore ? std::min(before, entry_v2_[i]) : peak_v2_[i];
    profiles_[i] = Trapezoid(moves_[i], std::min(entry_v2_[i], cruise), cruise,
                             std::min(entry_v2_[i + 1], cruise));
    before = cruise;
  }
}

void Planner::LimitJunctionsForward() {
  entry_v2_[0] = calm_entry_v2_[0] = 0;
  for (size_t i = 1; i < moves_.size(); ++i) {
    const KinematicMove& before = moves_[i - 1];
    entry_v2_[i] =
        std::min(KlipperJunctionV2(before, moves_[i], limits_), entry_v2_[i - 1] + ReachV2(before));
    calm_entry_v2_[i] = std::min(entry_v2_[i], calm_entry_v2_[i - 1] + calm_reach_v2_[i - 1]);
  }
  entry_v2_[moves_.size()] = calm_entry_v2_[moves_.size()] = 0;
}

void Planner::LimitJunctionsBackward() {
  double peak = 0;
  bool waiting = false;  // moves follow that take their peak from this one
  for (size_t i = moves_.size(); i-- > 0;) {
    const double reachable = entry_v2_[i + 1] + ReachV2(moves_[i]);
    const double calm_reachable = calm_entry_v2_[i + 1] + calm_reach_v2_[i];
    entry_v2_[i] = std::min(entry_v2_[i], reachable);
    calm_entry_v2_[i] = std::min(calm_entry_v2_[i], calm_reachable);
    if (calm_entry_v2_[i] == calm_reachable) {
      peak_v2_[i] = kAsBefore;
      waiting = true;
      continue;
    }
    if (waiting || calm_entry_v2_[i] + calm_reach_v2_[i] > calm_entry_v2_[i + 1]) {
      peak = (calm_entry_v2_[i] + calm_reachable) / 2;
    }
    waiting = false;
    peak_v2_[i] = std::min({(entry_v2_[i] + reachable) / 2, Squared(moves_[i].speed_mm_s), peak});
  }
}

}  // namespace slicefarm::motion
