#pragma once

#include <span>
#include <vector>

#include "common/kinematics/planner.h"
#include "common/model/options/machine_limits.h"

namespace slicefarm {

/// Klipper's look-ahead. Junctions follow klipper_junction.h. If a move would accelerate only to
/// decelerate at once, its peak speed is lowered (minimum_cruise_ratio). The lowered peak is the
/// speed reached with the acceleration times 1 - minimum_cruise_ratio. Source: Klipper's
/// documentation, "Kinematics".
class KlipperPlanner : public Planner {
 public:
  explicit KlipperPlanner(const MachineLimits& limits) : Planner(limits) {}

  KinematicMove Limited(const KinematicMove& move) const override;
  void Add(const KinematicMove& move) override;
  std::span<const MoveProfile> Stop() override;

 private:
  /// A queued move with the greatest squared speeds that earlier moves allow. `calm` values use the
  /// acceleration reduced by minimum_cruise_ratio.
  struct Queued {
    KinematicMove move;  ///< move after Limited()
    double entry_v2 = 0;
    double calm_entry_v2 = 0;
    double calm_reach_v2 = 0;
    double peak_v2 = 0;
  };

  void LimitBackward();

  std::vector<Queued> queue_;
  std::vector<MoveProfile> profiles_;
};

}  // namespace slicefarm
