#pragma once

#include <span>
#include <vector>

#include "common/kinematics/planner.h"

namespace slicefarm {

/// Planner with one backward and one forward pass over the moves. The moves are as fast as the
/// junctions allow. A derived class only adds the rules of its firmware.
class TwoPassPlanner : public Planner {
 public:
  /// Rules of a firmware.
  struct Rules {
    KinematicMove (*limited)(KinematicMove move, const MachineLimits& limits);
    // Greatest squared speeds in mm^2/s^2: at the start of the first move, and at the junction of
    // two moves. The moves are results of Limited().
    double (*start_v2)(const KinematicMove& first, const MachineLimits& limits);
    double (*junction_v2)(const KinematicMove& before, const KinematicMove& move,
                          const MachineLimits& limits);
    double rest_v2 = 0;  ///< squared speed at the end of the sequence, in mm^2/s^2
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
  std::vector<KinematicMove> moves_;  ///< moves after Limited()
  std::vector<double> entry_v2_;      ///< greatest squared speed at the start of each move
  std::vector<MoveProfile> profiles_;
};

}  // namespace slicefarm
