#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Round section of a branch in one layer.
struct BranchDisc {
  Point at;
  Coord radius_nm = 0;

  friend auto operator<=>(const BranchDisc&, const BranchDisc&) = default;
};

/// Indices of two discs that are joined into one outline.
struct BranchNeck {
  size_t a = 0;
  size_t b = 0;

  friend auto operator<=>(const BranchNeck&, const BranchNeck&) = default;
};

/// Widest gap between two discs that a neck joins, in nm. Beads bridge this gap, so a neck needs no
/// support.
inline constexpr Coord kMostNeckGapNm = 1'500'000;
/// Largest half width of a neck, in nm. With this width, the loops of the discs in the layer above
/// are supported where they cross the sides of the neck.
inline constexpr Coord kHalfNeckNm = 900'000;

/// Returns the necks that join neighbouring discs into chains, the narrowest gaps first. One loop
/// around a chain saves the travels between its branches, and the branches of a chain stabilize
/// each other.
///
/// A disc has at most two necks, and chains do not close into rings. If discs on all sides of
/// another disc were joined, the loop of the disc in the middle would have no support. REQUIRES:
/// `discs` are sorted. Cost: O(n m) for n discs, with m discs in a strip as wide as the largest
/// disc and the gap.
std::vector<BranchNeck> NecksBetween(std::span<const BranchDisc> discs);

/// Returns the rectangle of a neck from centre to centre, counter-clockwise. The neck is as wide as
/// the smaller disc, but at most 2 kHalfNeckNm. REQUIRES: the centres differ.
Polygon OutlineOfNeck(const BranchDisc& a, const BranchDisc& b);

}  // namespace slicefarm::planning
