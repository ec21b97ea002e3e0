#pragma once

#include <span>
#include <vector>

#include "services/infill/algo/lines/piece.h"

namespace slicefarm::infill {

/// Beads that run along each other lie this many widths apart at least: nearer ones are one place
/// filled twice.
inline constexpr double kLeastApart = 0.62;

/// A part of a ring, by arc length from its first point, beside which a piece runs.
struct TakenSpan {
  double from_nm = 0;
  double to_nm = 0;
  int32_t piece = 0;
};

/// Where along a region's edge pieces run beside it, at an angle of 20 degrees at most and nearer
/// than kLeastApart: a bead along the edge would lie on top of theirs. By ring, sorted by where
/// they begin. Cost: O(n + m) for n points of the region and m of pieces, of like length.
std::vector<std::vector<TakenSpan>> TakenEdge(const MultiPolygon& region,
                                              std::span<const Piece> pieces, double width_nm);

/// What beads along a stretch of a ring have room for.
struct StretchRoom {
  bool links = true;     ///< a bead all along it; it may lie on another one for a width
  double ahead_nm = 0;   ///< a bead from where it begins, so far
  double behind_nm = 0;  ///< a bead from where it ends, so far back
};

/// Of the stretch from `from_nm` on. `taken`: of the ring, which is `ring_nm` long.
StretchRoom RoomAlong(const std::vector<TakenSpan>& taken, double ring_nm, double from_nm,
                      double length_nm, double width_nm);

/// The length of a ring up to each of its points, and of the whole ring.
std::vector<double> CornerLengths(const Polygon& ring);

}  // namespace slicefarm::infill
