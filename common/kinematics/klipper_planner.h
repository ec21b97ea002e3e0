#pragma once

#include <span>
#include <vector>

#include "common/kinematics/planner.h"
#include "common/model/options/machine_limits.h"

namespace slicefarm {

/// Klipper's look-ahead. Junctions follow klipper_junction.h. If a move would accelerate and then
/// decelerate immediately, its peak speed is lowered (minimum_cruise_ratio). The lowered peak is
/// the speed reached with the acceleration times 1 - minimum_cruise_ratio. Source: Klipper's
/// documentation, "Kinematics".
class KlipperPlanner : public Planner {
 public:
  explicit KlipperPlanner(const MachineLimits& limits) : Planner(limits) {}

  KinematicMove Limited(const KinematicMove& move) const override;
  void Add(const KinematicMove& move) override;
  std::span<const MoveProfile> Stop() override;

 private:
  /// Queued move with the greatest squared speeds that earlier moves allow. Members with `calm` are
  /// computed with the acceleration reduced by minimum_cruise_ratio.
  struct Queued {
    KinematicMove move;  ///< result of Limited()
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
