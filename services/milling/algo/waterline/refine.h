#pragma once

#include "common/base/cancel_token.h"
#include "services/milling/algo/push/local_push.h"
#include "services/milling/algo/waterline/weave.h"

namespace slicefarm::milling {

/// What is needed to push a cutter along any fiber of a level.
struct LevelPush {
  const FiberFrame& x;  ///< rows
  const FiberFrame& y;  ///< columns
  const Cutter& cutter;
  const TriangleGrid& triangles;
  double z_mm = 0;
};

struct Refinement {
  double tolerance_mm = 0;      ///< > 0
  double least_step_mm = 0.01;  ///< > 0
};

/// Puts crossings of fibers between those of the grid into a loop where it bends: between two
/// points that are farther apart than twice the least step, one on the fiber through their middle
/// that meets their chord more steeply, if it lies off the chord by more than the tolerance, and so
/// on on both sides of it. What bends both ways between two points and meets their chord in its
/// middle is not seen. Incomplete once `cancel` says so. Cost: a PushLocally for each point that is
/// put in, and one for each pair of neighbours.
WovenLoop Refined(const WovenLoop& loop, const LevelPush& level, const Refinement& how,
                  const CancelToken& cancel = {});

}  // namespace slicefarm::milling
