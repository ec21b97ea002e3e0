#pragma once

#include <vector>

#include "common/kinematics/jerk_junction.h"
#include "common/kinematics/planner.h"
#include "common/model/options/machine_limits.h"

namespace slicefarm {

/// slicefarm's own look-ahead, for machines that follow the host: speed, acceleration and jerk stay
/// within their limits (MachineLimits::jerk_mm_s3) all along the way.
///
/// Curves of short moves count as one span as long as their paces (what the bends at their ends
/// allow) differ by no more than a tenth: they are passed at the slowest of these. A span speeds up
/// and slows down by up to seven phases of even jerk (jerk_ramp.h); where spans meet, the
/// acceleration is 0, and the speed is what the bend allows (jerk_junction.h) and passes backward
/// and forward leave.
class JerkPlanner : public Planner {
 public:
  explicit JerkPlanner(const MachineLimits& limits) : Planner(limits) {}

  KinematicMove Limited(const KinematicMove& move) const override;
  void Add(const KinematicMove& move) override { moves_.push_back(Limited(move)); }
  std::span<const MoveProfile> Stop() override;

 private:
  /// Moves [first, last) that are planned as one way.
  struct Span {
    size_t first = 0;
    size_t last = 0;
    double length_mm = 0;
    double slowest_mm_s = 0;  ///< of the moves' paces: the span's top speed
    double fastest_mm_s = 0;
    double acceleration_mm_s2 = 0;
    double entry_mm_s = 0;
  };

  RampLimits LimitsOf(const Span& span) const {
    return {span.acceleration_mm_s2, limits().jerk_mm_s3};
  }
  void FindBends();
  void FindSpans();
  bool Joins(const Span& span, size_t move) const;
  double PaceOf(size_t move) const;
  void LimitEntries();
  void Run(const Span& span, double exit_mm_s);

  std::vector<KinematicMove> moves_;  ///< limited
  std::vector<Bend> bends_;  ///< before each move; before the first and after the last: stops
  std::vector<double> through_mm_s_;  ///< speeds through them
  std::vector<Span> spans_;
  std::vector<MoveProfile> profiles_;
};

}  // namespace slicefarm
