#pragma once

#include <limits>
#include <span>
#include <vector>

#include "services/infill/algo/lines/piece.h"
#include "services/infill/algo/lines/ring_way.h"
#include "services/infill/algo/linking/taken_edge.h"

namespace slicefarm::infill {

inline constexpr int32_t kNoEnd = -1;

/// The ends of pieces in the order in which they lie along the edge of their region. Ends 2i and
/// 2i + 1 are those of piece i, so e ^ 1 is the other end of the same piece. A stretch is the part
/// of a ring from an end forwards to the next one, and has that end's number.
class EdgeEnds {
 public:
  /// `region` and `pieces` must outlive this. All of the edge is free. Cost: O(n + k log k).
  EdgeEnds(const MultiPolygon& region, std::span<const Piece> pieces);

  /// Says where beads of that width have no room, by ring.
  void SetTaken(const std::vector<std::vector<TakenSpan>>& taken, Coord width_nm);

  int32_t size() const { return static_cast<int32_t>(ends_.size()); }
  int32_t PieceCount() const { return size() / 2; }
  const Piece& PieceAt(int32_t piece) const { return pieces_[static_cast<size_t>(piece)]; }

  /// Ends that lie on the edge, ring by ring.
  const std::vector<int32_t>& OnEdge() const { return order_; }
  bool IsOnEdge(int32_t end) const { return At(end).place.ring >= 0; }
  /// The neighbour along the ring; the end itself where it is alone. REQUIRES: on the edge.
  int32_t Next(int32_t end) const { return At(end).next; }
  int32_t Previous(int32_t end) const { return At(end).previous; }
  /// Length in nm of a stretch. REQUIRES: on the edge.
  double StretchLength(int32_t end) const { return At(end).stretch_nm; }
  /// The same for a link; infinite where other beads lie in its way. REQUIRES: on the edge.
  double LinkLength(int32_t end) const {
    return At(end).room.links ? At(end).stretch_nm : std::numeric_limits<double>::infinity();
  }
  /// What a bead along a stretch has room for. REQUIRES: on the edge.
  const StretchRoom& RoomOf(int32_t end) const { return At(end).room; }

  Point PlaceOf(int32_t end) const;
  /// The points of a stretch, both ends' places with them.
  Polyline StretchPoints(int32_t end) const;

 private:
  struct End {
    EdgePlace place;
    int32_t next = kNoEnd;
    int32_t previous = kNoEnd;
    double along_nm = 0;  ///< the ring, from its first point
    double stretch_nm = 0;
    StretchRoom room{};  ///< of the stretch
  };

  const End& At(int32_t end) const { return ends_[static_cast<size_t>(end)]; }
  void SortAlongRings();

  std::span<const Piece> pieces_;
  std::vector<const Polygon*> rings_;
  std::vector<std::vector<double>> corner_at_;  ///< along each ring, its length at last
  std::vector<End> ends_;
  std::vector<int32_t> order_;
};

}  // namespace slicefarm::infill
