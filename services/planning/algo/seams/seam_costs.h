#pragma once

#include <vector>

#include "common/model/options/seam_position.h"
#include "services/planning/algo/seams/seam_candidates.h"
#include "services/planning/algo/seams/seam_forest.h"

namespace slicefarm::planning {

/// Number of a ring in a job, for costs that must differ from ring to ring (random seams).
struct RingNumber {
  int32_t object = 0;
  int32_t layer = 0;
  int32_t ring = 0;
};

/// Returns the cost of a seam at each point in `candidates`.
/// - Shape: 0 at a sharp inner corner, 0.5 at a sharp outer corner, 3.5 on a straight wall. These
///   values are for points in plain view; hidden points cost up to a fifth less.
/// - Overhang, the distance beyond the layer below in layer heights: 4 per height from 0.6 heights
///   on, 20 from 1.43, and 5 from 2.43.
///
/// The seam position selects the main cost:
///   aligned  first the shape, then the visibility; of nearly equal points the rear-most,
///            then the left-most.
///   rear     the distance from the rear.
///   hidden   first the visibility.
///   random   a number that depends on `number` and the point alone.
///
/// Blocked points have the highest cost. On a ring with enforced points, points that are not
/// enforced have the second highest cost. Enforced points are cheaper in the middle of their
/// section of the ring (except with `random`), and still cheaper at corners. The costs of steps
/// from layer to layer are not included, see StepCostOf. Shapes: one cost per point. `seen`:
/// visibility of each point, in [0, 1]. REQUIRES: the position is not `nearest`.
std::vector<double> SeamCosts(const std::vector<SeamCandidate>& candidates,
                              const std::vector<double>& seen, SeamPosition position,
                              RingNumber number);

/// Returns the costs of steps between the seams of consecutive layers. They are zero for `random`,
/// where seams need not form a line.
StepCost StepCostOf(SeamPosition position);

/// Returns true if the wall at this point overhangs the layer below by more than 55 degrees from
/// the vertical.
bool Overhangs(const SeamCandidate& candidate);

}  // namespace slicefarm::planning
