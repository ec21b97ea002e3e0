#pragma once

#include <vector>

#include "common/base/cancel_token.h"
#include "services/planning/algo/supports/generator/branch_drawing.h"
#include "services/planning/algo/supports/generator/clearance.h"
#include "services/planning/algo/supports/generator/columns.h"
#include "services/planning/algo/supports/generator/support_heights.h"
#include "services/planning/algo/supports/generator/support_plan.h"
#include "services/planning/algo/supports/generator/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

// The functions below stop early after a cancellation. Their results are then unusable.

/// Returns the sheets (interfaces below the part), indexed by layer of support. The sheet of a
/// layer is the free part of its own contacts and of the contacts of the top_interface_layers - 1
/// layers above. If top_interface_layers is 0, it is the free part of the layer's own contacts.
/// Cost: a union and a boolean operation per layer.
std::vector<MultiPolygon> Sheets(const SupportHeights& heights, const Contacts& contacts,
                                 const Clearance& clearance, const SupportOptions& options,
                                 int threads, const CancelToken& cancel = {});

/// Returns the floors (interfaces on the part), indexed by layer of support. `bodies`: all support
/// of each layer. The floor of a layer is the part of its body that is on top of the part, or less
/// than bottom_interface_layers layers above the lowest layer there.
std::vector<MultiPolygon> Floors(const SupportProblem& problem, const SupportHeights& heights,
                                 const std::vector<MultiPolygon>& bodies,
                                 const SupportOptions& options, int threads,
                                 const CancelToken& cancel = {});

/// Removes islands of columns narrower than `narrow_nm` that support neither a contact nor a column
/// above. Such islands are the remains of columns that a blocked area has cut. Cost: one or two
/// boolean operations for each narrow island.
void DropUseless(const Contacts& contacts, Coord narrow_nm, std::vector<MultiPolygon>& columns);

/// Returns layers of support from columns: interfaces under contacts and on the part, and a base of
/// the remaining area. Empty layers are omitted.
std::vector<SupportLayer> ColumnLayers(const SupportProblem& problem, const SupportHeights& heights,
                                       const std::vector<MultiPolygon>& columns,
                                       const Contacts& contacts, const SupportOptions& options,
                                       int threads, const CancelToken& cancel = {});

/// Returns plinths, indexed by layer of support: support for sheets so near to the bed that
/// branches cannot spread below them. In each layer up to 2 mm above the bed, the plinth is the
/// free area below all contacts up to this height.
std::vector<MultiPolygon> Plinths(const SupportHeights& heights, const Contacts& contacts,
                                  const Clearance& clearance, int threads,
                                  const CancelToken& cancel = {});

/// Returns layers of support from branches, the sheets on them, and plinths. Plinths have the role
/// kBase, with sparse lines. Empty layers are omitted.
std::vector<SupportLayer> BranchLayers(const SupportProblem& problem, const SupportHeights& heights,
                                       const std::vector<BranchSections>& branches,
                                       const std::vector<MultiPolygon>& sheets,
                                       const std::vector<MultiPolygon>& plinths,
                                       const SupportOptions& options, int threads,
                                       const CancelToken& cancel = {});

}  // namespace slicefarm::planning
