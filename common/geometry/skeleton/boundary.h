#pragma once

#include <optional>
#include <vector>

#include "common/geometry/polygon.h"
#include "common/geometry/vector.h"

namespace slicefarm {

/// Directed edge of a boundary, with the region to its left. `previous` and `next` are the indices
/// of the neighbouring edges.
struct BoundaryEdge {
  Point from;
  Point to;
  int previous = 0;
  int next = 0;

  /// Returns the distance of `p` from the line of the edge, times the edge's length. It is positive
  /// if `p` is to the left of the edge.
  double SideOf(const Vector2& p) const { return Cross(ToVector(to - from), p - ToVector(from)); }
};

/// A part of a boundary that a point of the region can be nearest to: an edge, or the reflex corner
/// at the start of an edge.
struct BoundaryFeature {
  int edge = 0;
  bool is_corner = false;

  friend bool operator==(const BoundaryFeature&, const BoundaryFeature&) = default;
};

/// Boundary of one connected region, as input of its medial axis. Coordinates are multiples of
/// `unit_nm`, relative to `origin`. INVARIANT: no two edges cross or touch, except neighbours at
/// their common corner, and no corner is on the line through its neighbours. Both conditions are
/// tested exactly.
struct Boundary {
  Point origin;
  Coord unit_nm = 1;
  std::vector<Polygon> rings;  ///< all rings, the outer ring first
  std::vector<BoundaryEdge> edges;

  int Holes() const { return static_cast<int>(rings.size()) - 1; }
  /// Returns true if the interior angle at the start of `edge` is more than 180 degrees.
  bool StartsReflex(int edge) const;
  /// Returns true if the interior angle at the start of `edge` is less than 180 degrees.
  bool StartsConvex(int edge) const;
  /// Returns the feature that precedes `feature` on its ring.
  BoundaryFeature Before(BoundaryFeature feature) const;
  /// Returns the edges in nm from `origin`.
  std::vector<BoundaryEdge> EdgesInNm() const;
};

/// Returns the boundary of `region` on a grid of `unit_nm`. Returns nothing if the boundary does
/// not fulfil the invariant on this grid, or is wider or higher than 2^31 units. Cost: the cost of
/// AreSimple.
std::optional<Boundary> MakeBoundary(const PolygonWithHoles& region, Coord unit_nm);

/// Returns the boundary on a grid of 1 um if possible, otherwise on a grid of 1 nm. The coarser
/// grid has fewer edges that are almost but not exactly parallel; such edges reduce the precision
/// of a diagram.
std::optional<Boundary> MakeBoundary(const PolygonWithHoles& region);

}  // namespace slicefarm
