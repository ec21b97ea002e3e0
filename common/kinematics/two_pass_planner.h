#pragma once

#include <span>
#include <vector>

#include "common/kinematics/planner.h"

namespace slicefarm {

/// Always as fast as the junctions allow: what differs from firmware to firmware are its rules.
class TwoPassPlanner : public Planner {
 public:
  struct Rules {
    KinematicMove (*limited)(KinematicMove move, const MachineLimits& limits);
    // Greatest squared speeds in mm^2/s^2, of limited moves: out of rest, and from move to move.
    double (*start_v2)(const KinematicMove& first, const MachineLimits& limits);
    double (*junction_v2)(const KinematicMove& before, const KinematicMove& move,
                          const MachineLimits& limits);
    double rest_v2 = 0;  ///< what counts as rest at the end
  };

  TwoPassPlanner(const Rules& rules, const MachineLimits& limits)
      : Planner(limits), rules_(rules) {}

  KinematicMove Limited(const KinematicMove& move) const override {
    return rules_.limited(move, limits());
  }
  void Add(const KinematicMove& move) override;
  std::span<const MoveProfile> Stop() override;

 private:
  Rules rules_;
  std::vector<KinematicMove> moves_;  ///< limited
  std::vector<double> entry_v2_;      ///< greatest
  std::vector<MoveProfile> profiles_;
};

}  // namespace slicefarm
