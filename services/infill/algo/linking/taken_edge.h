#pragma once

#include <span>
#include <vector>

#include "services/infill/algo/lines/piece.h"

namespace slicefarm::infill {

/// Smallest distance between parallel beads, in bead widths. Nearer beads would fill the same area
/// twice.
inline constexpr double kLeastApart = 0.62;

/// Part of a ring that has a piece beside it, given by two arc lengths from the ring's first point.
/// `piece`: index of the piece.
struct TakenSpan {
  double from_nm = 0;
  double to_nm = 0;
  int32_t piece = 0;
};

/// Returns the parts of a region's boundary that have pieces beside them, at an angle of at most 20
/// degrees and nearer than kLeastApart widths. A bead along such a part would overlap the piece.
/// The result has one list per ring, sorted by start. Cost: O(n + m) for n edges of the region and
/// m segments of pieces, of similar length.
std::vector<std::vector<TakenSpan>> TakenEdge(const MultiPolygon& region,
                                              std::span<const Piece> pieces, double width_nm);

/// Free length for beads along an edge part (EdgeEnds).
struct SpanClearance {
  /// True if a bead fits along the whole edge part. The bead may overlap other beads over a length
  /// of at most one width.
  bool links = true;
  double ahead_nm = 0;   ///< free length in nm, measured forwards from the edge part's start
  double behind_nm = 0;  ///< free length in nm, measured backwards from the edge part's end
};

/// Taken parts of one ring, for queries about many edge parts.
class TakenRing {
 public:
  /// `taken`: parts of the ring that are not free, sorted by start; must outlive this object.
  /// `ring_nm`: length of the ring.
  TakenRing(std::span<const TakenSpan> taken, double ring_nm);

  /// Returns the free length of the edge part that begins `from_nm` after the ring's first point
  /// and is `length_nm` long. Cost: O(log n) for n taken parts, and the parts that it meets.
  SpanClearance Along(double from_nm, double length_nm, double width_nm) const;

 private:
  std::span<const TakenSpan> taken_;
  std::vector<double> farthest_nm_;  ///< farthest end of each part and of all parts before it
  double ring_nm_;
};

/// Returns the distance of each point of a ring from its first point, along the ring; then the
/// length of the whole ring. All in nm.
std::vector<double> CornerLengths(const Polygon& ring);

}  // namespace slicefarm::infill
