#pragma once

#include <vector>

#include "common/base/cancel_token.h"
#include "services/planning/algo/support/support_plan.h"
#include "services/planning/algo/support/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Cuts holes into branches, from the top down, where the loops of the layer above would be printed
/// into the air: branches are hollow, so where several have become one outline, the loops that lie
/// inside of it have nothing below. The loop around such a hole is what they lie on, down to where
/// an outline, a sheet, the part or the bed carries it.
///
/// Stretches of a loop up to kBridgedNm between two carried places span their gap by themselves.
/// Layers must follow each other without gaps in height.
/// Cost: a raster of each layer on `threads` threads; boolean operations where a loop is not
/// carried.
void KeepRings(const SupportProblem& problem, const SupportOptions& options, int threads,
               const CancelToken& cancel, std::vector<SupportLayer>& layers);

inline constexpr Coord kBridgedNm = 4'000'000;

}  // namespace slicefarm::planning
