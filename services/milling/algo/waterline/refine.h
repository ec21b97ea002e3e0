#pragma once

#include "common/base/cancel_token.h"
#include "services/milling/algo/push/local_push.h"
#include "services/milling/algo/waterline/weave.h"

namespace slicefarm::milling {

/// Data for pushing a cutter along any fiber of a level.
struct LevelPush {
  const FiberFrame& x;  ///< frame for rows
  const FiberFrame& y;  ///< frame for columns
  const Cutter& cutter;
  const TriangleGrid& triangles;
  double z_mm = 0;
};

/// Options for Refined.
struct Refinement {
  double tolerance_mm = 0;      ///< > 0
  double least_step_mm = 0.01;  ///< > 0
};

/// Refines a loop where it bends: adds crossings with fibers between the fibers of the grid. Two
/// points farther apart than twice the least step get a candidate between them. It is on the fiber
/// through their middle that meets their chord more steeply. The candidate is added if it deviates
/// from the chord by more than the tolerance, and both halves are then refined.
///
/// A bend to both sides that crosses the chord in its middle is not detected. The result is
/// incomplete if `cancel` is set. Cost: a PushLocally for each added point and for each pair of
/// neighbours.
WovenLoop Refined(const WovenLoop& loop, const LevelPush& level, const Refinement& how,
                  const CancelToken& cancel = {});

}  // namespace slicefarm::milling
