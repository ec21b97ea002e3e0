#pragma once

#include <vector>

#include "common/base/cancel_token.h"
#include "services/planning/algo/support/branches.h"
#include "services/planning/algo/support/clearance.h"
#include "services/planning/algo/support/support_heights.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// What branches cover in a layer of support, free of the part and others.
struct BranchSections {
  MultiPolygon thin;
  MultiPolygon thick;  ///< with a place as wide as double_wall_diameter_nm

  friend bool operator==(const BranchSections&, const BranchSections&) = default;
};

/// The sections of branches, by layer of support: discs at the middle of the layer's height (within
/// 0.01 mm of round), joined by necks (branch_necks.h), united, and cut to what is free. Near the
/// bed branches widen to a foot. Cost: a union a layer, and a boolean operation where branches pass
/// the part closely; on `threads` threads.
std::vector<BranchSections> DrawBranches(const Branches& branches, const ReachField& field,
                                         const SupportHeights& heights, const Clearance& clearance,
                                         const SupportOptions& options, int threads,
                                         const CancelToken& cancel);

}  // namespace slicefarm::planning
