#pragma once

#include <vector>

#include "common/base/cancel_token.h"
#include "services/planning/algo/support/support_plan.h"
#include "services/planning/algo/support/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Removes unsupported areas from layers of support, from the bed up. These are islands that rest
/// on neither support nor part, and areas more than kReachNm beyond their support.
///
/// A part supports a layer with its bottom at most one layer plus the lower gap above it, unless
/// bed_only is set. Layers must follow each other without gaps in height.
/// Cost: a raster of each layer on `threads` threads; boolean operations where the raster leaves a
/// doubt.
void KeepStanding(const SupportProblem& problem, const SupportOptions& options, int threads,
                  const CancelToken& cancel, std::vector<SupportLayer>& layers);

inline constexpr Coord kReachNm = 950'000;

}  // namespace slicefarm::planning
