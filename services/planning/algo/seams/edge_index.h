#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Finds the edge of a section's outlines that is nearest to a point: a grid of the edges.
class EdgeIndex {
 public:
  /// The nearest point of the outlines.
  struct Hit {
    int32_t ring = 0;     ///< by the order of ForEachRing
    int32_t edge = 0;     ///< of the ring: from this point to the next
    double share = 0;     ///< where on the edge, in [0, 1]
    double distance_nm = 0;
    bool inside = false;  ///< the point that was asked for lies in the solid, or on its edge
  };

  /// Copies what it needs. Cost: O(points + cells), of which there are no more than a few for each
  /// edge.
  explicit EdgeIndex(const MultiPolygon& outlines);

  /// None if there is no edge within `reach_nm`. The first of equals. Cost: O(edges in the cells
  /// around).
  std::optional<Hit> Nearest(Point to, Coord reach_nm) const;

 private:
  struct Edge {
    Point from;
    Point to;
    int32_t ring = 0;
    int32_t index = 0;   ///< within the ring
    bool reflex = false;  ///< the corner where it starts points into the solid
  };
  struct Best {
    double distance2 = 0;
    int32_t edge = -1;
    double share = 0;
  };

  void AddRing(const Polygon& ring, int32_t number);
  template <typename Visit>
  void ForEachCell(const Edge& edge, const Visit& visit) const;
  void FillCells();
  Coord Column(Coord x) const;
  Coord Row(Coord y) const;
  void LookInto(Coord column, Coord row, Point to, Best& best) const;
  bool IsInside(Point p, const Best& best) const;

  std::vector<Edge> edges_;
  std::vector<int32_t> first_edge_;  ///< of each ring
  Box box_;
  Coord cell_nm_ = 0;
  Coord columns_ = 0;
  Coord rows_ = 0;
  std::vector<int32_t> first_;  ///< in members_, by cell; one more at the end
  std::vector<int32_t> members_;
};

}  // namespace slicefarm::planning
