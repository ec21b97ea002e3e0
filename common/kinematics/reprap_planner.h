#pragma once

#include "common/kinematics/two_pass_planner.h"

namespace slicefarm {

/// RepRapFirmware's look-ahead (reprap_junction.h).
struct RepRapPlanner : TwoPassPlanner {
  explicit RepRapPlanner(const MachineLimits& limits);
};

}  // namespace slicefarm
