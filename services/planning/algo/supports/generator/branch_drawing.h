#pragma once

#include <vector>

#include "common/base/cancel_token.h"
#include "services/planning/algo/supports/generator/branches.h"
#include "services/planning/algo/supports/generator/clearance.h"
#include "services/planning/algo/supports/generator/support_heights.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Area of branches in one layer of support, without the areas that the part and other objects
/// block.
struct BranchSections {
  MultiPolygon thin;
  /// islands that are at least double_wall_diameter_nm wide somewhere; `thin` has all other islands
  MultiPolygon thick;

  friend bool operator==(const BranchSections&, const BranchSections&) = default;
};

/// Returns the sections of branches, indexed by layer of support. A section is the union of discs
/// and necks (branch_necks.h) at the middle of the layer's height, cut to the free area
/// (Clearance). Discs are round within 0.01 mm. Near the bed branches widen to a foot. Cost: one
/// union per layer, and one boolean operation where branches are close to the part; on `threads`
/// threads.
std::vector<BranchSections> DrawBranches(const Branches& branches, const ReachField& field,
                                         const SupportHeights& heights, const Clearance& clearance,
                                         const SupportOptions& options, int threads,
                                         const CancelToken& cancel);

}  // namespace slicefarm::planning
