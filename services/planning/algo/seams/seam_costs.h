#pragma once

#include <vector>

#include "common/model/options/seam_position.h"
#include "services/planning/algo/seams/seam_forest.h"
#include "services/planning/algo/seams/seam_places.h"

namespace slicefarm::planning {

/// Which ring of a job it is, for what must differ from ring to ring.
struct RingNumber {
  int32_t object = 0;
  int32_t layer = 0;
  int32_t ring = 0;
};

/// How little each place suits a seam: 0 at a sharp inner corner, 0.5 at a sharp outer one, 3.5 on
/// a straight wall, all in plain view and a fifth less out of it; for each height of the layer that
/// it hangs over the layer below 4 more from 0.6 heights on, 20 from 1.43 and 5 from 2.43. A step
/// of a millimetre from layer to layer costs 4, and 4 more if it goes sideways; a jump 40
/// (StepCostOf).
///   aligned  corner first, then how much is seen of it; of those that are nearly equal the
///            rear-most, then left-most
///   rear     how far it is from the rear
///   hidden   how much is seen of it first
///   random   a number that depends on nothing but `number`
/// Blocked places cost more than anything else, then those that are not enforced where some are. Of
/// enforced ones those in the middle of their run are better, but for `random`, and corners better
/// still.
/// Shapes: one a place; `seen`: of each, in [0, 1]. REQUIRES: not nearest.
std::vector<double> SeamCosts(const std::vector<SeamPlace>& places, const std::vector<double>& seen,
                              SeamPosition position, RingNumber number);

/// What steps cost in this mode: nothing if seams need not be in line.
StepCost StepCostOf(SeamPosition position);

/// Whether it hangs over the layer below at more than 55 degrees from upright.
bool Overhangs(const SeamPlace& place);

}  // namespace slicefarm::planning
