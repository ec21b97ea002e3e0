#pragma once

#include "services/motion/algo/kinematics/two_pass_planner.h"

namespace slicefarm::motion {

/// Marlin's look-ahead, by junction deviation where the limits have one, else by classic jerk
/// (marlin_junction.h).
class MarlinPlanner : public TwoPassPlanner {
 public:
  explicit MarlinPlanner(const MachineLimits& limits) : TwoPassPlanner(limits) {}

  KinematicMove Limited(const KinematicMove& move) const override;

 protected:
  double StartV2(const KinematicMove& first) const override;
  double JunctionV2(const KinematicMove& before, const KinematicMove& move) const override;
  double RestV2() const override;
};

}  // namespace slicefarm::motion
