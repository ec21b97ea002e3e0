#pragma once

#include "services/motion/algo/kinematics/two_pass_planner.h"

namespace slicefarm::motion {

/// RepRapFirmware's look-ahead (reprap_junction.h). From rest to rest.
class RepRapPlanner : public TwoPassPlanner {
 public:
  explicit RepRapPlanner(const MachineLimits& limits) : TwoPassPlanner(limits) {}

  KinematicMove Limited(const KinematicMove& move) const override;

 protected:
  double StartV2(const KinematicMove& first) const override;
  double JunctionV2(const KinematicMove& before, const KinematicMove& move) const override;
  double RestV2() const override;
};

}  // namespace slicefarm::motion
