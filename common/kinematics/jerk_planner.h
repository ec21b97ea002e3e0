#pragma once

#include <vector>

#include "common/kinematics/jerk_junction.h"
#include "common/kinematics/planner.h"
#include "common/model/options/machine_limits.h"

namespace slicefarm {

/// slicefarm's own look-ahead. Unlike the other planners, it follows no printer's firmware: it is
/// for machines that execute a planned motion exactly. Speed, acceleration and jerk are within
/// their limits (MachineLimits::jerk_mm_s3) along the whole path.
///
/// Each move has a pace: the speed that the move and the bends at its ends allow. Sharp bends
/// (Bend::sharp) do not limit the pace. Consecutive moves form one span if no bend between them is
/// sharp and if their paces differ by at most a tenth. The top speed of a span is its slowest pace.
/// A span accelerates and decelerates in up to seven phases of constant jerk (jerk_ramp.h). Where
/// one span ends and the next begins, the acceleration is 0. The speed at this point is limited by
/// the bend (jerk_junction.h) and by a backward and a forward pass.
class JerkPlanner : public Planner {
 public:
  explicit JerkPlanner(const MachineLimits& limits) : Planner(limits) {}

  KinematicMove Limited(const KinematicMove& move) const override;
  void Add(const KinematicMove& move) override { moves_.push_back(Limited(move)); }
  std::span<const MoveProfile> Stop() override;

 private:
  /// Moves with indices [first, last) that are planned as one path.
  struct Span {
    size_t first = 0;
    size_t last = 0;
    double length_mm = 0;
    double slowest_mm_s = 0;  ///< lowest pace of the moves: the span's top speed
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

  std::vector<KinematicMove> moves_;  ///< moves after Limited()
  /// bend before each move, and after the last one; the first and the last bend are stops
  std::vector<Bend> bends_;
  std::vector<double> through_mm_s_;  ///< greatest speed through each bend
  std::vector<Span> spans_;
  std::vector<MoveProfile> profiles_;
};

}  // namespace slicefarm
