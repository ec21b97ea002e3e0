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

/// A stretch of a ring, from an end of a piece to that of the next one.
struct EdgeStretch {
  double from_nm = 0;  ///< along the ring
  double length_nm = 0;
  int32_t from_piece = 0;
  int32_t to_piece = 0;
};

/// What beads along a stretch have room for.
struct StretchRoom {
  bool links = true;         ///< a bead all along it
  double from_wedge_nm = 0;  ///< so far the piece from which it begins runs beside it
  double to_wedge_nm = 0;    ///< and that at which it ends
  double ahead_nm = 0;       ///< a bead from where it begins, so far
  double behind_nm = 0;      ///< a bead from where it ends, so far back
};

/// `taken`: of the ring, which is `ring_nm` long. A link may lie on another bead for half a width;
/// and in the wedge between its own pieces and the edge only where they can be cut off there.
StretchRoom RoomAlong(const std::vector<TakenSpan>& taken, double ring_nm,
                      const EdgeStretch& stretch, double width_nm);

}  // namespace slicefarm::infill
