#pragma once

#include "common/model/options/support_options.h"
#include "services/planning/algo/support/support_problem.h"
#include "services/planning/algo/support/tolerances.h"

namespace slicefarm::planning {

/// Calls visit(outlines) with the layers of the part that support a layer of support with its
/// bottom at `bottom_nm`. Their tops are at most one layer plus the lower gap below it. There are
/// none with bed_only.
template <typename Visit>
void ForEachPartBelow(const SupportProblem& problem, const SupportOptions& options, Coord bottom_nm,
                      Visit visit) {
  if (options.bed_only) return;
  const Coord highest = bottom_nm - options.bottom_gap_nm + support::kSameHeightNm;
  const Coord lowest = highest - options.layer_height_nm - 2 * support::kSameHeightNm;
  for (const PartLayer& part : problem.part)
    if (part.top_nm > lowest && part.top_nm <= highest) visit(*part.outlines);
}

}  // namespace slicefarm::planning
