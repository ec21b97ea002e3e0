#pragma once

#include <optional>
#include <vector>

#include "common/geometry/polygon.h"
#include "services/planning/algo/rings/region_edges.h"

namespace slicefarm::planning {

/// Estimates where the outlines of a part curl up at overhangs, layer by layer.
///
/// An overhang shrinks as it cools. Where its outline is convex, the outline is longer than the
/// wall that supports it, and shrinking lifts it. Let w be the width of outer walls, d the distance
/// of a point of the outline from the layer below, and r the radius of curvature. For 0.2 w < d <
/// 1.1 w the point rises by sqrt(d^2 - w^2 r / 100 mm), if this root is real.
///
/// A bead within 3 w of a risen point of the layer below rises too, but by three quarters of the
/// bead's height less. The rise is at most ten layer heights. Points on supports do not rise.
/// Source: the constants of the estimate of curled heights in PrusaSlicer 2.9, which are based on
/// prints. PrusaSlicer computes the rise for each bead; here it is computed for the outline.
class CurledEdges {
 public:
  /// `width_nm`: width of outer walls. REQUIRES: > 0.
  explicit CurledEdges(Coord width_nm) : width_nm_(width_nm) {}

  /// Adds the next layer and returns the area that rises more than 0.1 mm above the top of this
  /// layer, with a margin of one width. `above_supports`: part of the outline that is directly
  /// above supports. Cost: O(length / 0.5 mm), plus the cost of RegionEdges for the outline.
  MultiPolygon Next(const MultiPolygon& outline, const MultiPolygon& above_supports,
                    Coord height_nm);

 private:
  struct Below {
    MultiPolygon outline;
    RegionEdges edges;
  };
  /// Piece of an outline, and its height above the top of its layer.
  struct Risen {
    Point from, to;
    double rise_nm = 0;
  };
  class Places;

  void AddRing(const Polygon& ring, const Places& below, const MultiPolygon& above_supports,
               Coord height_nm, std::vector<Risen>& risen) const;
  double RiseAt(Point place, double radius_nm) const;
  void KeepUncovered(const RegionEdges& edges, Coord height_nm, std::vector<Risen>& risen) const;
  MultiPolygon AreaOf(const std::vector<Risen>& risen) const;

  const Coord width_nm_;
  std::optional<Below> below_;
  std::vector<Risen> risen_;  ///< risen pieces of the layer below
};

}  // namespace slicefarm::planning
