#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/planning/algo/support/reach_field.h"
#include "services/planning/algo/support/support_heights.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Where a branch has a round section; between two nodes it leans straight from one to the other.
struct BranchNode {
  Point at;
  Coord z_nm = 0;
  Coord radius_nm = 0;
  int32_t below =
      -1;  ///< the next node down; always a later one. -1: it goes straight down from here
  Coord foot_nm = 0;  ///< of nodes without one below: how far down. What it stands on cuts it there
  bool on_bed = true;  ///< of these: what it stands on

  friend bool operator==(const BranchNode&, const BranchNode&) = default;
};

/// The radius of a foot on the bed, where there is room.
inline constexpr Coord kFootRadiusNm = 2'500'000;

struct Branches {
  std::vector<BranchNode> nodes;  ///< by falling height of the slab
  /// Tips from which nothing that may carry them can be reached; they have no nodes.
  int64_t lost = 0;
};

/// Branches from under the undersides down to the bed or the part.
///
/// From the top slab down. What neither branches that pass nor the layer below carries gets tips
/// (tips.h). Branches in sight of each other become partners, the nearest first, and lean towards
/// the middle (angle_rad while they are thin or if they would not meet else, slow_angle_rad once
/// they are thick); partners that can be at one place in the next slab become one. A branch without
/// a partner goes where its nearest neighbour goes. On its way to another one a branch makes do
/// with less room than its radius, else it looks for room, near the bed for that of a foot. The
/// field says where a branch can go: it moves to the place nearest to where it wants from which the
/// bed can be reached, or else the part. A tip so deep in a hole that the field knows no way goes
/// straight down to what is there.
///
/// Radii: from that of a tip to that of a branch at 6 degrees, further on at three quarters of
/// diameter_angle_rad; less where the way is narrow, but no less than a tip's. undersides: by layer
/// of support, ascending pixels of the field's grid that need to be carried. Errors: Cancelled.
/// Cost: O(branches * slabs) and that of tips. Serial: little beside the field.
absl::StatusOr<Branches> GrowBranches(const ReachField& field, const SupportHeights& heights,
                                      const std::vector<std::vector<int32_t>>& undersides,
                                      const SupportOptions& options, const CancelToken& cancel);

}  // namespace slicefarm::planning
