#pragma once

#include <optional>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// A directed edge of a boundary, the region to its left; and where the boundary goes on.
struct BoundaryEdge {
  Point from;
  Point to;
  int previous = 0;
  int next = 0;
};

/// The boundary of one connected region as the Voronoi diagram of segments needs it, in multiples
/// of `unit_nm` from `origin`. INVARIANT: no two edges cross or touch but for neighbours in the
/// corner they share, and no corner lies on the line through its neighbours; both decided exactly.
struct Boundary {
  Point origin;
  Coord unit_nm = 1;
  std::vector<Polygon> rings;  ///< the outer one first
  std::vector<BoundaryEdge> edges;

  int Holes() const { return static_cast<int>(rings.size()) - 1; }
  /// True if the region is more than half of what is around the corner in which `edge` starts.
  bool StartsReflex(int edge) const;
  bool StartsConvex(int edge) const;
};

/// The boundary of `region` on a grid of `unit_nm`; nothing if it does not meet the invariant
/// there, or is wider than 32 bits of the unit. Cost: that of AreSimple.
std::optional<Boundary> MakeBoundary(const PolygonWithHoles& region, Coord unit_nm);

/// On a grid of um if that will do, else of nm. On the coarser one fewer edges are almost but not
/// quite parallel, and these are what costs a diagram its precision.
std::optional<Boundary> MakeBoundary(const PolygonWithHoles& region);

}  // namespace slicefarm
