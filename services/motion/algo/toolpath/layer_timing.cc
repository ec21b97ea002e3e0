#include "services/motion/algo/toolpath/layer_timing.h"

#include <algorithm>
#include <numeric>

#include "common/base/portable_math.h"
#include "common/gcode/gcode_text.h"
#include "services/motion/algo/toolpath/arc_chords.h"
#include "services/motion/algo/toolpath/edge_moves.h"
#include "services/motion/algo/toolpath/print_speed.h"

namespace slicefarm::motion {
namespace {

double FirstBeadsAcceleration(std::span<const MoveSpan> spans) {
  for (const MoveSpan& span : spans)
    for (size_t i = span.first; i < span.last; ++i)
      if (span.path->moves[i].kind == MoveKind::kPrint)
        return span.path->moves[i].acceleration_mm_s2;
  return 0;
}

double Mm(int32_t um) { return static_cast<double>(um) / kUmPerMm; }

MoveArc Shifted(MoveArc arc, ShiftUm shift) {
  arc.centre.x += shift.x;
  arc.centre.y += shift.y;
  return arc;
}

}  // namespace

std::span<const double> LayerTiming::Times(std::span<const MoveSpan> spans) {
  times_.clear();
  if (spans.empty()) return times_;
  const Toolpath& first = *spans.front().path;
  MoveWalk walk({.z_um = first.start_z_um}, FirstBeadsAcceleration(spans));
  for (const MoveSpan& span : spans) {
    const Toolpath& path = *span.path;
    auto arc = std::ranges::lower_bound(path.arcs, span.first, {}, &MoveArc::first);
    for (size_t i = span.first; i < span.last;) {
      const EdgeMove before = walk.at();
      const bool is_arc = arc != path.arcs.end() && arc->first == i;
      int64_t filament = 0;
      for (const size_t end = is_arc ? arc->last : i + 1; i < end; ++i) {
        filament += path.moves[i].filament;
        walk.Go(path.moves[i], span.shift);
        times_.push_back(0);
      }
      if (is_arc) {
        QueueArc(before, walk.at(), Shifted(*arc++, span.shift), filament);
      } else if (&span == &spans.front() && i - 1 == first.approach) {
        PlanRun();
      } else if (const auto kinematic = ToKinematic(before, walk.at(), 0)) {
        Queue(*kinematic, walk.at().jerk_mm_s, times_.size() - 1);
      }
    }
  }
  PlanRun();
  return times_;
}

/// Queues a move. `jerk_mm_s`: its jerk in x and y; 0: unchanged.
void LayerTiming::Queue(const KinematicMove& move, double jerk_mm_s, size_t place) {
  if (jerk_mm_s > 0) planner_->SetJerk(jerk_mm_s);
  planner_->Add(move);
  run_.push_back(place);
}

/// Queues an arc as the chords that the firmware makes of it.
void LayerTiming::QueueArc(const EdgeMove& from, const EdgeMove& to, const MoveArc& arc,
                           int64_t filament) {
  const Arc travel{{Mm(from.x_um), Mm(from.y_um)},
                   {Mm(to.x_um), Mm(to.y_um)},
                   {Mm(arc.centre.x), Mm(arc.centre.y)},
                   arc.clockwise};
  const double speed = SpeedOf(to.feed_rate), radius = travel.StartRadius();
  const auto ends =
      ArcChords(travel, radius * travel.Angle(), firmware_.ArcSegmentMm(radius, speed));
  const double filament_mm =
      static_cast<double>(filament) / kFilamentUnitsPerMm / static_cast<double>(ends.size());
  Vector2 at = travel.from;
  for (const Vector2& end : ends) {
    const double length = Hypot(end.x() - at.x(), end.y() - at.y());
    const double scale = 1 / length;
    if (length > 0)
      Queue({length,
             {(end.x() - at.x()) * scale, (end.y() - at.y()) * scale, 0, filament_mm * scale},
             speed,
             to.acceleration_mm_s2},
            to.jerk_mm_s, times_.size() - 1);
    at = end;
  }
}

void LayerTiming::PlanRun() {
  const auto profiles = planner_->Stop();
  for (size_t i = 0; i < run_.size(); ++i) times_[run_[i]] += profiles[i].time_s;
  run_.clear();
}

void AddTimes(std::span<const MoveSpan> spans, std::span<const double> times, ProgramStats& stats) {
  auto time = times.begin();
  for (const MoveSpan& span : spans) {
    for (size_t i = span.first; i < span.last; ++i, ++time) {
      const Move& move = span.path->moves[i];
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

void AddUse(int32_t copy, const FeatureUse& use, std::vector<CopyUse>& copies) {
  auto found = std::ranges::lower_bound(copies, copy, {}, &CopyUse::copy);
  if (found == copies.end() || found->copy != copy) found = copies.insert(found, {copy, {}});
  found->use.Add(use);
}

void AddCopyTimes(std::span<const MoveSpan> spans, std::span<const double> times,
                  std::vector<CopyUse>& copies) {
  const auto add = [&](int32_t copy, std::span<const double> of_moves) {
    if (copy == kNoCopy || of_moves.empty()) return;
    AddUse(copy, {.time_s = std::accumulate(of_moves.begin(), of_moves.end(), 0.0)}, copies);
  };
  for (const MoveSpan& span : spans) {
    const size_t own = span.FirstOwn() - span.first;
    const size_t count = span.last - span.first;
    add(span.travel_copy, times.first(own));
    add(span.copy, times.subspan(own, count - own));
    times = times.subspan(count);
  }
}

}  // namespace slicefarm::motion
