#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// A place on something, and how far it is from where it was asked for.
struct Nearest {
  Point at;
  double distance_nm = 0;
};

struct Edge {
  Point a;
  Point b;
};

/// The edges of a region in square cells, about one edge each: for many questions about one region.
class EdgeGrid {
 public:
  explicit EdgeGrid(const MultiPolygon& region);

  /// The nearest place on an edge. None: there are no edges. Cost: O(1) near evenly spread edges.
  std::optional<Nearest> NearestTo(Point p) const;

  /// Whether a point lies inside (even-odd); on an edge it may be either. Cost: O(cells of a row).
  bool IsInside(Point p) const;

  /// The edges in the cells that the box of a segment touches; each once, in the region's order.
  std::vector<Edge> Near(Point a, Point b) const;

 private:
  struct Cells {
    int64_t first_x, first_y, last_x, last_y;
  };

  Cells CellsOf(const Box& box) const;
  std::span<const int32_t> EdgesIn(int64_t x, int64_t y) const;

  std::vector<Edge> edges_;
  Point corner_;
  Coord side_ = 1;
  int64_t width_ = 0, height_ = 0;
  std::vector<int32_t> begins_;  ///< by cell, x running fastest; one more than cells
  std::vector<int32_t> places_;  ///< in edges_
};

}  // namespace slicefarm::planning
