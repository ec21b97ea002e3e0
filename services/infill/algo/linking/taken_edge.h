#pragma once

#include <span>
#include <vector>

#include "services/infill/algo/lines/piece.h"

namespace slicefarm::infill {

/// Least distance between parallel beads, in widths. Nearer beads would fill the same area twice.
inline constexpr double kLeastApart = 0.62;

/// Part of a ring beside which a piece runs, by arc length from the ring's first point.
struct TakenSpan {
  double from_nm = 0;
  double to_nm = 0;
  int32_t piece = 0;
};

/// Returns the parts of a region's edge beside which pieces run, at an angle of at most 20 degrees
/// and nearer than kLeastApart. A bead along such a part would overlap the piece. The result has
/// one list per ring, sorted by start. Cost: O(n + m) for n points of the region and m of pieces,
/// of similar length.
std::vector<std::vector<TakenSpan>> TakenEdge(const MultiPolygon& region,
                                              std::span<const Piece> pieces, double width_nm);

/// Free space for beads along an edge part.
struct StretchRoom {
  /// True: a bead fits along the whole edge part; it may overlap another bead for one width.
  bool links = true;
  double ahead_nm = 0;   ///< free length from the edge part's start
  double behind_nm = 0;  ///< free length back from the edge part's end
};

/// Returns the free space of the edge part that begins at `from_nm`. `taken`: occupied parts of the
/// ring, which is `ring_nm` long.
StretchRoom RoomAlong(const std::vector<TakenSpan>& taken, double ring_nm, double from_nm,
                      double length_nm, double width_nm);

/// Returns the length of a ring up to each of its points, and of the whole ring.
std::vector<double> CornerLengths(const Polygon& ring);

}  // namespace slicefarm::infill
