#include "common/kinematics/jerk_planner.h"

#include <algorithm>
#include <cmath>

#include "common/base/span_log.h"
#include "common/kinematics/marlin_junction.h"

namespace slicefarm {
namespace {

/// Junction deviation if the limits have none.
constexpr double kDeviationMm = 0.01;
/// Smallest ratio of the slowest to the fastest pace in a span.
constexpr double kAlike = 0.9;

}  // namespace

KinematicMove JerkPlanner::Limited(const KinematicMove& move) const {
  return LimitedByMarlin(move, limits());
}

std::span<const MoveProfile> JerkPlanner::Stop() {
  profiles_.assign(moves_.size(), {});
  if (!moves_.empty()) {
    FindBends();
    FindSpans();
    LimitEntries();
    for (size_t i = 0; i < spans_.size(); ++i)
      Run(spans_[i], i + 1 < spans_.size() ? spans_[i + 1].entry_mm_s : 0);
  }
  moves_.clear();
  return profiles_;
}

void JerkPlanner::FindBends() {
  const double given = limits().junction_deviation_mm;
  const double deviation = given > 0 ? given : kDeviationMm;
  const size_t count = moves_.size();
  bends_.assign(count + 1, {.sharp = true, .stop = true});
  for (size_t i = 1; i < count; ++i) bends_[i] = BendBetween(moves_[i - 1], moves_[i], deviation);
  through_mm_s_.assign(count + 1, 0);
  for (size_t i = 1; i < count; ++i) {
    double change = 0;  // change of the curvature along the moves on both sides
    if (!bends_[i].sharp) {
      for (const size_t side : {i - 1, i + 1}) {
        const double path = moves_[side < i ? i - 1 : i].length_mm;
        if (!bends_[side].sharp)
          change = std::max(change, std::abs(bends_[side].curvature - bends_[i].curvature) / path);
      }
    }
    const double a = std::min(moves_[i - 1].acceleration_mm_s2, moves_[i].acceleration_mm_s2);
    through_mm_s_[i] = SpeedThrough(bends_[i], change, {a, limits().jerk_mm_s3});
  }
}

double JerkPlanner::PaceOf(size_t move) const {
  double pace = moves_[move].speed_mm_s;
  for (const size_t end : {move, move + 1})
    if (!bends_[end].sharp) pace = std::min(pace, through_mm_s_[end]);
  return pace;
}

bool JerkPlanner::Joins(const Span& span, size_t move) const {
  const double pace = PaceOf(move);
  return !bends_[move].sharp &&
         std::min(pace, span.slowest_mm_s) >= kAlike * std::max(pace, span.fastest_mm_s);
}

void JerkPlanner::FindSpans() {
  spans_.clear();
  for (size_t i = 0; i < moves_.size(); ++i) {
    const double pace = PaceOf(i), a = moves_[i].acceleration_mm_s2;
    if (spans_.empty() || !Joins(spans_.back(), i)) spans_.push_back({i, i, 0, pace, pace, a, 0});
    Span& span = spans_.back();
    span.last = i + 1;
    span.length_mm += moves_[i].length_mm;
    span.slowest_mm_s = std::min(span.slowest_mm_s, pace);
    span.fastest_mm_s = std::max(span.fastest_mm_s, pace);
    span.acceleration_mm_s2 = std::min(span.acceleration_mm_s2, a);
  }
}

void JerkPlanner::LimitEntries() {
  for (size_t i = 1; i < spans_.size(); ++i)
    spans_[i].entry_mm_s = std::min(
        {through_mm_s_[spans_[i].first], spans_[i - 1].slowest_mm_s, spans_[i].slowest_mm_s});
  const auto lower = [this](Span& to, double from_mm_s, const Span& over) {
    const RampLimits limits = LimitsOf(over);
    if (to.entry_mm_s <= from_mm_s ||
        RampLength(from_mm_s, to.entry_mm_s, limits) <= over.length_mm)
      return;
    to.entry_mm_s = std::min(to.entry_mm_s, SpeedAfter(from_mm_s, over.length_mm, limits));
  };
  double exit_mm_s = 0;
  for (size_t i = spans_.size(); i-- > 0;) {
    lower(spans_[i], exit_mm_s, spans_[i]);
    exit_mm_s = spans_[i].entry_mm_s;
  }
  for (size_t i = 1; i < spans_.size(); ++i)
    lower(spans_[i], spans_[i - 1].entry_mm_s, spans_[i - 1]);
}

void JerkPlanner::Run(const Span& span, double exit_mm_s) {
  const JerkProfile profile(span.length_mm, span.entry_mm_s, span.slowest_mm_s, exit_mm_s,
                            LimitsOf(span));
  ProfileWalk walk(profile);
  ProfileWalk::Passing at = {0, span.entry_mm_s};
  double move_mm = 0;
  for (size_t i = span.first; i < span.last; ++i) {
    move_mm += moves_[i].length_mm;
    const bool last = i + 1 == span.last;
    const ProfileWalk::Passing next =
        last ? ProfileWalk::Passing{profile.time_s(), exit_mm_s} : walk.At(move_mm);
    const double cruise = span.last - span.first == 1 ? profile.peak_mm_s()
                                                      : std::max(at.speed_mm_s, next.speed_mm_s);
    profiles_[i] = {at.speed_mm_s, cruise, next.speed_mm_s, next.time_s - at.time_s};
    at = next;
  }
}

}  // namespace slicefarm
