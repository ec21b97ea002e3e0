#pragma once

#include <vector>

#include "services/planning/algo/supports/generator/overhangs.h"
#include "services/planning/algo/supports/generator/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Removes overhangs that print well enough without supports. Areas that touch each other in
/// consecutive layers are one overhang. It is small if it is nowhere wider than two walls, seen
/// from below. Overhangs that begin in the air, reach more than 3 mm beyond the layer below, or are
/// enforced stay. `overhangs`: one per layer of the part. Cost: a boolean operation for each pair
/// of areas with touching boxes, and a union and an offset for each overhang.
void RemoveSmallOverhangs(const SupportProblem& problem, const SupportOptions& options,
                          std::vector<Overhang>& overhangs);

}  // namespace slicefarm::planning
