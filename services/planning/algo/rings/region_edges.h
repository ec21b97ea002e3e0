#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "common/geometry/edge_index.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Index of the edges of a region, for many searches of near edges.
class RegionEdges {
 public:
  using Edge = EdgeIndex::Edge;

  /// Nearest point on an edge.
  struct Hit {
    int32_t ring = 0;  ///< index of the ring in the order of ForEachRing
    /// Index of the edge in the ring: from the point with this index to the next.
    int32_t edge = 0;
    double share = 0;  ///< position on the edge, in [0, 1]
    Point at;
    double distance_nm = 0;
    bool inside = false;  ///< true if the queried point is in the region or on its boundary
  };

  static constexpr Coord kAnyReach = std::numeric_limits<Coord>::max() / 4;

  /// Copies the edges into an index of squares of a millimetre, or larger squares if there would be
  /// more than a few per edge. Cost: O(edges + squares).
  explicit RegionEdges(const MultiPolygon& region);

  /// Returns the nearest point on an edge, or nullopt if no edge is within `reach_nm`. Of equally
  /// near edges the first is returned. Cost: O(edges within the distance of the nearest one).
  std::optional<Hit> Nearest(Point to, Coord reach_nm = kAnyReach) const;

  /// Returns true if a point is inside the region (even-odd rule). For a point on an edge the
  /// result may be either. Cost: O(edges in the point's row of squares).
  bool IsInside(Point p) const;

  /// Returns the edges in the squares that the box of a segment touches, each once, in the region's
  /// order.
  std::vector<Edge> Near(Point a, Point b) const;

 private:
  struct Best {
    double distance2 = 0;
    int32_t edge = -1;
    double share = 0;
  };

  void LookAt(int32_t edge, Point to, Best& best) const;
  bool IsInside(Point p, const Best& best) const;
  std::vector<int32_t> EdgesIn(const Box& box) const;

  EdgeIndex index_;
  /// Index of the first edge of each ring; the last entry is the number of edges.
  std::vector<int32_t> first_edge_;
  /// true for each edge that starts at a reflex corner of the region
  std::vector<bool> reflex_;
};

}  // namespace slicefarm::planning
