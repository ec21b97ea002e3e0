#pragma once

#include <vector>

#include "common/base/cancel_token.h"
#include "services/planning/algo/support/support_plan.h"
#include "services/planning/algo/support/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Takes from layers of support, from the bed up, what nothing carries: islands that lie on neither
/// support nor part, and what reaches more than kReachNm beyond what they lie on.
///
/// A part carries a layer whose bottom is at most a layer and the lower gap above it, unless
/// bed_only is set. Layers must follow each other without gaps in height.
/// Cost: a raster of each layer on `threads` threads; boolean operations where there is doubt.
void KeepStanding(const SupportProblem& problem, const SupportOptions& options, int threads,
                  const CancelToken& cancel, std::vector<SupportLayer>& layers);

inline constexpr Coord kReachNm = 950'000;

}  // namespace slicefarm::planning
