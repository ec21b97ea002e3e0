#pragma once

#include <vector>

#include "common/base/cancel_token.h"
#include "services/planning/algo/support/branch_drawing.h"
#include "services/planning/algo/support/clearance.h"
#include "services/planning/algo/support/columns.h"
#include "services/planning/algo/support/support_heights.h"
#include "services/planning/algo/support/support_plan.h"
#include "services/planning/algo/support/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

// All of these stop in the middle once `cancel` says so; their results are of no use then.

/// The sheets that lie against the part: in each layer, the contacts of the lowest
/// top_interface_layers - 1 layers above it and its own, as far as they are free. Without interface
/// layers, its own contacts. Cost: a union and a boolean operation a layer.
std::vector<MultiPolygon> Sheets(const SupportHeights& heights, const Contacts& contacts,
                                 const Clearance& clearance, const SupportOptions& options,
                                 int threads, const CancelToken& cancel = {});

/// What of `bodies` (all support of a layer) lies on the part, or fewer than
/// bottom_interface_layers above what does.
std::vector<MultiPolygon> Floors(const SupportProblem& problem, const SupportHeights& heights,
                                 const std::vector<MultiPolygon>& bodies,
                                 const SupportOptions& options, int threads,
                                 const CancelToken& cancel = {});

/// Takes away islands of columns, narrower than `narrow_nm`, that carry neither a contact nor a
/// column above them: where what is not free has cut them off. Cost: a boolean operation or two for
/// each narrow island.
void DropUseless(const Contacts& contacts, Coord narrow_nm, std::vector<MultiPolygon>& columns);

/// Returns layers of support made of columns and the contacts on them.
std::vector<SupportLayer> ColumnLayers(const SupportProblem& problem, const SupportHeights& heights,
                                       const std::vector<MultiPolygon>& columns,
                                       const Contacts& contacts, const SupportOptions& options,
                                       int threads, const CancelToken& cancel = {});

/// What carries sheets so near the bed that branches cannot spread below them: in each layer, all that
/// is free of the contacts up to a height above the bed.
std::vector<MultiPolygon> Plinths(const SupportHeights& heights, const Contacts& contacts,
                                  const Clearance& clearance, int threads,
                                  const CancelToken& cancel = {});

/// Layers of support from branches, the sheets on them, and plinths, which have sparse lines.
std::vector<SupportLayer> BranchLayers(const SupportProblem& problem, const SupportHeights& heights,
                                       const std::vector<BranchSections>& branches,
                                       const std::vector<MultiPolygon>& sheets,
                                       const std::vector<MultiPolygon>& plinths,
                                       const SupportOptions& options, int threads,
                                       const CancelToken& cancel = {});

}  // namespace slicefarm::planning
