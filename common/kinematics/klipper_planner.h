#pragma once

#include <span>
#include <vector>

#include "common/kinematics/planner.h"
#include "common/model/options/machine_limits.h"

namespace slicefarm {

/// Klipper's look-ahead: junctions by klipper_junction.h; peaks of moves that would speed up only
/// to slow down at once are lowered (minimum_cruise_ratio): to where the acceleration times
/// 1 - minimum_cruise_ratio would bring them. Source: Klipper's documentation, "Kinematics".
class KlipperPlanner : public Planner {
 public:
  explicit KlipperPlanner(const MachineLimits& limits) : Planner(limits) {}

  KinematicMove Limited(const KinematicMove& move) const override;
  void Add(const KinematicMove& move) override;
  std::span<const MoveProfile> Stop() override;

 private:
  /// A queued move with the greatest squared speeds that moves before it allow; `calm`: with the
  /// acceleration that minimum_cruise_ratio leaves.
  struct Queued {
    KinematicMove move;  ///< limited
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
