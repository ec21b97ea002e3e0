#pragma once

#include <optional>
#include <vector>

#include "common/geometry/polygon.h"
#include "services/planning/algo/rings/region_edges.h"

namespace slicefarm::planning {

/// Where the edges of a part's overhangs curl up, layer by layer.
///
/// What hangs over shrinks as it cools. Where the edge turns outwards, it is longer than the wall
/// that holds it, and shrinking lifts it: with a width w, a place that lies d beyond the layer below,
/// 0.2 w < d < 1.1 w, on a turn of radius r rises by sqrt(d^2 - w^2 r / 100 mm), if that is real. A
/// bead that comes to lie beside a place that has risen, within 3 w, rises with it, less three
/// quarters of its height. Nothing rises by more than ten layers. What supports carry does not rise.
/// Source: the figures of PrusaSlicer 2.9's estimate of curled heights, which come from prints; in
/// place of each of its beads the outline rises here.
class CurledEdges {
 public:
  /// `width_nm`: of outer walls. REQUIRES: > 0.
  explicit CurledEdges(Coord width_nm) : width_nm_(width_nm) {}

  /// What stands more than 0.1 mm above the top of the next layer, a width around. `carried`: what
  /// supports carry of it. Cost: as RegionEdges of the outline, and O(length / 0.5 mm).
  MultiPolygon Next(const MultiPolygon& outline, const MultiPolygon& carried, Coord height_nm);

 private:
  struct Below {
    MultiPolygon outline;
    RegionEdges edges;
  };
  /// A piece of an edge, and how far it stands above the top of its layer.
  struct Risen {
    Point from, to;
    double rise_nm = 0;
  };
  class Places;

  void AddRing(const Polygon& ring, const Places& below, const MultiPolygon& carried,
               Coord height_nm, std::vector<Risen>& risen) const;
  double RiseAt(Point place, double radius_nm) const;
  void KeepUncovered(const RegionEdges& edges, Coord height_nm, std::vector<Risen>& risen) const;
  MultiPolygon AreaOf(const std::vector<Risen>& risen) const;

  const Coord width_nm_;
  std::optional<Below> below_;
  std::vector<Risen> risen_;  ///< of the layer below
};

}  // namespace slicefarm::planning
