#pragma once

#include <span>
#include <vector>

#include "services/motion/algo/kinematics/planner.h"

namespace slicefarm::motion {

/// What planners that always go as fast as their junctions allow have in common.
class TwoPassPlanner : public Planner {
 public:
  explicit TwoPassPlanner(const MachineLimits& limits) : Planner(limits) {}

  void Add(const KinematicMove& move) override;
  std::span<const MoveProfile> Stop() override;

 protected:
  /// Greatest squared speeds in mm^2/s^2: out of rest, from move to move, and of what counts as
  /// rest at the end. The moves are limited.
  virtual double StartV2(const KinematicMove& first) const = 0;
  virtual double JunctionV2(const KinematicMove& before, const KinematicMove& move) const = 0;
  virtual double RestV2() const = 0;

 private:
  std::vector<KinematicMove> moves_;  ///< limited
  std::vector<double> entry_v2_;      ///< greatest
  std::vector<MoveProfile> profiles_;
};

}  // namespace slicefarm::motion
