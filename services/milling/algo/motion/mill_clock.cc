#include "services/milling/algo/motion/mill_clock.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "common/kinematics/jerk_planner.h"

namespace slicefarm::milling {
namespace {

/// Largest deviation of chords from an arc, as a fraction of the tolerance.
constexpr double kArcChordShare = 0.25;
/// Reduced feeds are multiples of 1 / kFeedSteps of the programmed feed. Fewer different feeds give
/// a shorter program, because it contains a feed only where it changes.
constexpr double kFeedSteps = 20;

MachineLimits LimitsOf(const MillingOptions& options) {
  const MachiningOptions& machining = options.machining;
  const auto& a = machining.max_acceleration_mm_s2;
  MachineLimits limits;
  limits.max_feedrate_mm_s = {};  // no limits per axis: speeds are along the path
  limits.max_acceleration_mm_s2 = {a[0], a[1], a[2], 0};
  limits.junction_deviation_mm = options.tolerance_mm;
  limits.jerk_mm_s3 = machining.jerk_mm_s3;
  return limits;
}

/// Computes the times of moves with the look-ahead planner, from standstill to standstill.
class MillClock {
 public:
  MillClock(const MillingOptions& options, size_t moves)
      : options_(options), planner_(LimitsOf(options)), times_(moves) {
    const auto& a = options.machining.max_acceleration_mm_s2;
    acceleration_mm_s2_ = *std::max_element(a.begin(), a.end());
  }

  void Add(size_t index, const MillMove& move, const Eigen::Vector3d& from_mm) {
    const bool rapid = move.kind == MoveKind::kRapid;
    const double fastest = options_.machining.rapid_mm_min;
    const double mm_s = (rapid ? fastest : std::min(fastest, move.feed_mm_min)) / 60;
    Eigen::Vector3d at = from_mm;
    for (const Eigen::Vector3d& to :
         PointsOf(move, from_mm, kArcChordShare * options_.tolerance_mm)) {
      const double length = (to - at).norm();
      if (length == 0) continue;
      const Eigen::Vector3d ratio = (to - at) / length;
      planner_.Add({length, {ratio.x(), ratio.y(), ratio.z(), 0}, mm_s, acceleration_mm_s2_});
      move_of_chord_.push_back(index);
      at = to;
    }
  }

  void Rest() {
    const std::span<const MoveProfile> profiles = planner_.Stop();
    for (size_t i = 0; i < profiles.size(); ++i) {
      MoveTime& time = times_[move_of_chord_[i]];
      time.seconds += profiles[i].time_s;
      time.fastest_mm_s = std::max(time.fastest_mm_s, profiles[i].cruise_mm_s);
    }
    move_of_chord_.clear();
  }

  std::vector<MoveTime> Take() { return std::move(times_); }

 private:
  const MillingOptions& options_;
  JerkPlanner planner_;
  double acceleration_mm_s2_ = 0;
  std::vector<size_t> move_of_chord_;  ///< move of each chord since the last standstill
  std::vector<MoveTime> times_;
};

}  // namespace

std::vector<MoveTime> TimesOf(std::span<const MillMove> moves, const MillingOptions& options,
                              const CancelToken& cancel) {
  MillClock clock(options, moves.size());
  for (size_t i = 1; i < moves.size(); ++i) {
    const bool was_rapid = moves[i - 1].kind == MoveKind::kRapid;
    if (was_rapid != (moves[i].kind == MoveKind::kRapid)) {
      clock.Rest();
      if (cancel.Cancelled()) return clock.Take();
    }
    clock.Add(i, moves[i], moves[i - 1].to_mm);
  }
  clock.Rest();
  return clock.Take();
}

void LowerFeeds(const MillingOptions& options, std::span<MillMove> moves,
                const CancelToken& cancel) {
  const std::vector<MoveTime> times = TimesOf(moves, options, cancel);
  for (size_t i = 1; i < times.size(); ++i) {
    MillMove& move = moves[i];
    if (move.kind == MoveKind::kRapid || times[i].seconds == 0) continue;
    const double steps = std::ceil(kFeedSteps * 60 * times[i].fastest_mm_s / move.feed_mm_min);
    if (steps < kFeedSteps) move.feed_mm_min *= steps / kFeedSteps;
  }
}

}  // namespace slicefarm::milling
