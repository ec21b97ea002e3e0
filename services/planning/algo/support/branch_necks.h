#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// The round section of a branch in one layer.
struct BranchDisc {
  Point at;
  Coord radius_nm = 0;

  friend auto operator<=>(const BranchDisc&, const BranchDisc&) = default;
};

/// Indices of two discs that become one outline.
struct BranchNeck {
  size_t a = 0;
  size_t b = 0;

  friend auto operator<=>(const BranchNeck&, const BranchNeck&) = default;
};

/// The widest gap between discs with a neck. Beads span it from disc to disc, so a neck needs
/// nothing below.
inline constexpr Coord kMostNeckGapNm = 1'500'000;
/// Half the width of a neck at most. The loops of the discs above lie on its edges where they cross
/// it.
inline constexpr Coord kHalfNeckNm = 900'000;

/// Returns the necks that join neighbouring discs to strings, the narrowest gaps first: one loop
/// around a string saves the travels between its branches, and branches of a string hold each
/// other.
///
/// A disc has two necks at most, and strings do not close to rings: an outline around discs on all
/// sides would leave the loop of one in their middle without anything below.
/// REQUIRES: `discs` ascend. Cost: O(n * discs in a strip as wide as the largest disc and the gap).
std::vector<BranchNeck> NecksBetween(std::span<const BranchDisc> discs);

/// Returns the rectangle from centre to centre, counter-clockwise, as wide as the smaller disc or a
/// neck at most. REQUIRES: the centres differ.
Polygon OutlineOfNeck(const BranchDisc& a, const BranchDisc& b);

}  // namespace slicefarm::planning
