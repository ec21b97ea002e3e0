#pragma once

#include "common/kinematics/two_pass_planner.h"
#include "common/model/options/machine_limits.h"

namespace slicefarm {

/// Marlin's look-ahead: by junction deviation if the limits have one, otherwise by classic jerk
/// (marlin_junction.h).
struct MarlinPlanner : TwoPassPlanner {
  explicit MarlinPlanner(const MachineLimits& limits);
};

}  // namespace slicefarm
