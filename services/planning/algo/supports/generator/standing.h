#pragma once

#include <vector>

#include "common/base/cancel_token.h"
#include "services/planning/algo/supports/generator/support_plan.h"
#include "services/planning/algo/supports/generator/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Removes unsupported areas from layers of support, from the bed up: islands that have neither
/// support nor part below them, and areas more than kReachNm beyond the area below.
///
/// A layer of the part supports a layer of support if the vertical gap between them is at most one
/// layer height plus the lower gap. With bed_only the part supports nothing. REQUIRES: the layers
/// have no gaps in height. Cost: a raster of each layer on `threads` threads; boolean operations
/// where the raster is not conclusive.
void KeepStanding(const SupportProblem& problem, const SupportOptions& options, int threads,
                  const CancelToken& cancel, std::vector<SupportLayer>& layers);

inline constexpr Coord kReachNm = 950'000;

}  // namespace slicefarm::planning
