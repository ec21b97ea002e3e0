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

/// Point on the middle line of a branch, with the branch's radius there. Between two nodes the
/// branch is straight.
struct BranchNode {
  Point at;
  Coord z_nm = 0;
  Coord radius_nm = 0;
  /// Index of the next lower node of the branch, larger than this node's index; -1: the branch
  /// leads straight down from here.
  int32_t below = -1;
  /// Only if `below` is -1: height above the bed down to which the branch is drawn, in nm. The part
  /// may cut it off higher (Clearance).
  Coord foot_nm = 0;
  /// only if `below` is -1: true if the branch ends on the bed, false if on the part
  bool on_bed = true;

  friend bool operator==(const BranchNode&, const BranchNode&) = default;
};

/// Radius of a branch's foot on the bed, if there is free space for it.
inline constexpr Coord kFootRadiusNm = 2'500'000;

/// All branches of an object.
struct Branches {
  std::vector<BranchNode> nodes;  ///< nodes from the top down: sorted by slab (reach_field.h)
  /// Number of tips from which no path leads to the bed or the part. Their branches are omitted.
  int64_t lost = 0;
};

/// Grows branches from the undersides of overhangs down to the bed or the part.
///
/// The slabs (reach_field.h) are processed from the top down. An underside gets tips (tips.h)
/// unless a passing branch or the layer below supports it. Pairs of branches in sight of each other
/// become partners, the nearest pair first, and lean towards the middle between them. A branch
/// leans by angle_rad while it is thin, or if it would not meet its partner otherwise. A thick
/// branch leans by slow_angle_rad. Partners that can reach one point in the next slab are merged. A
/// branch without a partner moves to the target of its nearest neighbour.
///
/// While a branch moves towards another one, it may pass gaps narrower than itself. Otherwise it
/// moves to where it fits; near the bed, to where its foot fits. The field tells where a branch can
/// move. The branch moves to the reachable point nearest to its target that still has a path to the
/// bed. If there is none, it moves to a point with a path to the part. A tip deep in a hole may
/// have no path in the field. Its branch goes straight down to the next surface.
///
/// Radii: a branch starts with the radius of a tip and widens at 6 degrees up to the radius of a
/// branch, then at three quarters of diameter_angle_rad. Radii are smaller on a narrow path, but at
/// least the radius of a tip. `undersides`: for each layer of support, the ascending indices of the
/// pixels of the field's grid that need support. Errors: Cancelled. Cost: O(branches * slabs), plus
/// the cost of tips. Single-threaded, because the field takes much longer.
absl::StatusOr<Branches> GrowBranches(const ReachField& field, const SupportHeights& heights,
                                      const std::vector<std::vector<int32_t>>& undersides,
                                      const SupportOptions& options, const CancelToken& cancel);

}  // namespace slicefarm::planning
