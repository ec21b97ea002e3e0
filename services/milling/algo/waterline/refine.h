#pragma once

#include "common/base/cancel_token.h"
#include "services/milling/algo/push/local_push.h"
#include "services/milling/algo/waterline/weave.h"

namespace slicefarm::milling {

/// Input for pushing a cutter along any fiber of a level.
struct LevelPush {
  const FiberFrame& x;  ///< frame for fibers along x (rows)
  const FiberFrame& y;  ///< frame for fibers along y (columns)
  const Cutter& cutter;
  const TriangleGrid& triangles;
  double z_mm = 0;
};

/// Options for Refined.
struct Refinement {
  double tolerance_mm = 0;  ///< largest deviation from a chord; > 0
  /// points closer than twice this distance get no point between them; > 0
  double least_step_mm = 0.01;
};

/// Refines a loop where it bends: inserts crossings with fibers between the fibers of the grid. Two
/// neighbouring points farther apart than twice the least step get a candidate between them. The
/// candidate is on a fiber through the middle of their chord: on the x fiber or the y fiber, the
/// one that crosses the chord at the larger angle. The candidate is added if it deviates from the
/// chord by more than the tolerance. Then both halves are refined.
///
/// An S-shaped bend that crosses its chord in the middle is not detected. The result is incomplete
/// if `cancel` is set. Cost: a PushLocally for each added point and for each pair of neighbours.
WovenLoop Refined(const WovenLoop& loop, const LevelPush& level, const Refinement& how,
                  const CancelToken& cancel = {});

}  // namespace slicefarm::milling
