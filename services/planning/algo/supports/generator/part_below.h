#pragma once

#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/support_problem.h"
#include "services/planning/algo/supports/generator/tolerances.h"

namespace slicefarm::planning {

/// Calls visit(outlines) for each layer of the part on which a layer of support may be printed.
/// `bottom_nm`: bottom of the layer of support. The tops of the visited layers are below
/// `bottom_nm` by at least the lower gap (bottom_gap_nm) and at most this gap plus one layer
/// height. With bed_only there are no such layers.
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
