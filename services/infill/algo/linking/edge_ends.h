#pragma once

#include <limits>
#include <span>
#include <vector>

#include "services/infill/algo/lines/piece.h"
#include "services/infill/algo/lines/ring_path.h"
#include "services/infill/algo/linking/taken_edge.h"

namespace slicefarm::infill {

/// Index that means "no end".
inline constexpr int32_t kNoEnd = -1;

/// Ends of pieces in their order along the boundary of their region. Ends 2i and 2i + 1 belong to
/// piece i, so that `end ^ 1` is the other end of the same piece. An edge part (`Span` in names)
/// is the part of a ring from one end forwards to the next end on the ring. The index of an edge
/// part is the index of its first end.
class EdgeEnds {
 public:
  /// Sorts the ends. After this, all edge parts are free for beads. `region` and `pieces` must
  /// outlive this object. Cost: O(n + k log k), n points of the region, k ends.
  EdgeEnds(const MultiPolygon& region, std::span<const Piece> pieces);

  /// Marks parts of each ring as not free for beads of `width_nm`. `taken`: one list per ring
  /// (TakenEdge).
  void SetTaken(const std::vector<std::vector<TakenSpan>>& taken, Coord width_nm);

  int32_t size() const { return static_cast<int32_t>(ends_.size()); }
  int32_t PieceCount() const { return size() / 2; }
  const Piece& PieceAt(int32_t piece) const { return pieces_[static_cast<size_t>(piece)]; }

  /// Returns the ends on the region's boundary, ring by ring, in their order along each ring.
  const std::vector<int32_t>& OnEdge() const { return order_; }
  bool IsOnEdge(int32_t end) const { return At(end).place.ring >= 0; }
  /// Returns the next end along the ring, or the end itself if it is the only one. REQUIRES:
  /// IsOnEdge(end).
  int32_t Next(int32_t end) const { return At(end).next; }
  int32_t Previous(int32_t end) const { return At(end).previous; }
  /// Returns the length of the edge part that begins at `end`, in nm. REQUIRES: IsOnEdge(end).
  double SpanLength(int32_t end) const { return At(end).span_nm; }
  /// Returns the length of a link along the edge part that begins at `end`, in nm, or infinity if
  /// another bead blocks it. REQUIRES: IsOnEdge(end).
  double LinkLength(int32_t end) const {
    return At(end).clearance.links ? At(end).span_nm : std::numeric_limits<double>::infinity();
  }
  /// Returns the free space for beads along the edge part that begins at `end`. REQUIRES:
  /// IsOnEdge(end).
  const SpanClearance& ClearanceOf(int32_t end) const { return At(end).clearance; }

  /// Returns the position of an end in the plane.
  Point PositionOf(int32_t end) const;
  /// Returns the points of the edge part that begins at `end`, including the positions of its two
  /// ends.
  Polyline SpanPoints(int32_t end) const;

 private:
  struct End {
    EdgePosition place;
    int32_t next = kNoEnd;
    int32_t previous = kNoEnd;
    double along_nm = 0;  ///< distance along the ring from its first point
    double span_nm = 0;
    SpanClearance clearance{};  ///< free space along the edge part that begins here
  };

  const End& At(int32_t end) const { return ends_[static_cast<size_t>(end)]; }
  void SortAlongRings();

  std::span<const Piece> pieces_;
  std::vector<const Polygon*> rings_;
  /// For each ring: the distance of each point from the first one along the ring, then the whole
  /// length.
  std::vector<std::vector<double>> corner_at_;
  std::vector<End> ends_;
  std::vector<int32_t> order_;
};

}  // namespace slicefarm::infill
