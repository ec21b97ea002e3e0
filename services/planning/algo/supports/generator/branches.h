#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/planning/algo/supports/generator/reach_field.h"
#include "services/planning/algo/supports/generator/support_heights.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Round section of a branch at one height. Between two nodes the branch is straight.
struct BranchNode {
  Point at;
  Coord z_nm = 0;
  Coord radius_nm = 0;
  int32_t below =
      -1;  ///< index of the next node down, always a later index; -1: straight down from here
  /// Only if `below` is -1: height at which the branch ends, in nm. The surface below cuts the
  /// branch there.
  Coord foot_nm = 0;
  /// only if `below` is -1: true if the branch ends on the bed, false if on the part
  bool on_bed = true;

  friend bool operator==(const BranchNode&, const BranchNode&) = default;
};

/// Radius of a foot on the bed, if there is free space for it.
inline constexpr Coord kFootRadiusNm = 2'500'000;

/// All branches of an object.
struct Branches {
  std::vector<BranchNode> nodes;  ///< nodes, sorted by slab from the top down
  /// Number of tips without a path to any support below. They have no nodes.
  int64_t lost = 0;
};

/// Grows branches from the undersides down to the bed or the part.
///
/// The slabs are processed from the top down. An underside gets tips (tips.h) unless a passing
/// branch or the layer below supports it. Branches in sight of each other become partners, the
/// nearest first, and lean towards their middle. They lean by angle_rad while they are thin, or if
/// they would not meet otherwise. Thick branches lean by slow_angle_rad. Partners that can reach
/// one point in the next slab are merged. A branch without a partner moves to its nearest
/// neighbour's target.
///
/// While a branch moves to another one, it may pass gaps narrower than itself. Otherwise it moves
/// to where it fits; near the bed, to where its foot fits. The field tells where a branch can move.
/// The branch moves to the reachable point nearest to its target that still has a path to the bed,
/// or else to the part. A tip deep in a hole may have no path in the field. Its branch goes
/// straight down to the next surface.
///
/// Radii: from the radius of a tip, growing at 6 degrees up to the radius of a branch, then at
/// three quarters of diameter_angle_rad. Radii are smaller on a narrow path, but at least the
/// radius of a tip. `undersides`: for each layer of support, the pixels of the field's grid that
/// need support, ascending. Errors: Cancelled. Cost: O(branches * slabs), plus the cost of tips.
/// Single-threaded, because the field takes much longer.
absl::StatusOr<Branches> GrowBranches(const ReachField& field, const SupportHeights& heights,
                                      const std::vector<std::vector<int32_t>>& undersides,
                                      const SupportOptions& options, const CancelToken& cancel);

}  // namespace slicefarm::planning
