#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "common/geometry/edge_index.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// The edges of a region, for many questions about what is near.
class RegionEdges {
 public:
  using Edge = EdgeIndex::Edge;

  /// The nearest place on an edge.
  struct Hit {
    int32_t ring = 0;  ///< by the order of ForEachRing
    int32_t edge = 0;  ///< of the ring: from this point to the next
    double share = 0;  ///< where on the edge, in [0, 1]
    Point at;
    double distance_nm = 0;
    bool inside = false;  ///< the point that was asked for lies in the region, or on its edge
  };

  static constexpr Coord kAnyReach = std::numeric_limits<Coord>::max() / 4;

  /// Copies what it needs. Cost: O(edges + squares of a millimetre), of which there are no more than
  /// a few for each edge.
  explicit RegionEdges(const MultiPolygon& region);

  /// None if there is no edge within `reach_nm`. The first of equals. Cost: O(edges around, as far
  /// as the nearest one).
  std::optional<Hit> Nearest(Point to, Coord reach_nm = kAnyReach) const;

  /// Whether a point lies inside (even-odd); on an edge it may be either. Cost: O(edges in the rows
  /// of squares that it is in).
  bool IsInside(Point p) const;

  /// The edges in the squares that the box of a segment touches; each once, in the region's order.
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
  std::vector<int32_t> first_edge_;  ///< of each ring; one more at the end
  std::vector<bool> reflex_;         ///< by edge: the corner where it starts points into the region
};

}  // namespace slicefarm::planning
