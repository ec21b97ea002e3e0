#pragma once

#include <vector>

#include "common/base/cancel_token.h"
#include "services/planning/algo/supports/generator/support_plan.h"
#include "services/planning/algo/supports/generator/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Cuts holes into branches, from the top down, where the loops of the layer above would be printed
/// into the air. Branches are hollow. Where several branches have merged into one outline, the
/// loops of the separate branches above are inside this outline and have nothing below them. A hole
/// gets a loop of its own along its boundary; this loop supports the loops above. Holes continue
/// down to an outline, a sheet, the part or the bed.
///
/// A section of a loop between two supported points that is at most kBridgedNm long is a bridge and
/// needs no hole. REQUIRES: the layers have no gaps in height. Cost: a raster of each layer on
/// `threads` threads; boolean operations where a loop has no support.
void KeepRings(const SupportProblem& problem, const SupportOptions& options, int threads,
               const CancelToken& cancel, std::vector<SupportLayer>& layers);

inline constexpr Coord kBridgedNm = 4'000'000;

}  // namespace slicefarm::planning
