#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm {

/// The edges of a region by the squares of a grid that they pass, to find those near a place.
class EdgeIndex {
 public:
  struct Edge {
    Point a, b;  ///< the region lies to the left
    int32_t ring = 0;
    int32_t edge = 0;
  };

  /// Squares of about `square_nm`, or larger where they would be many more than edges.
  /// Cost: O(edges + squares).
  EdgeIndex(const MultiPolygon& region, Coord square_nm);

  /// Calls visit(edge number) for all edges that may come within the box, each once or more.
  template <typename Visit>
  void ForEachNear(const Box& box, Visit visit) const {
    const int32_t left = Column(box.min.x), right = Column(box.max.x);
    for (int32_t row = Row(box.min.y); row <= Row(box.max.y); ++row) {
      for (int32_t column = left; column <= right; ++column) {
        const auto square = static_cast<size_t>(row) * columns_ + column;
        for (int32_t i = begin_[square]; i < begin_[square + 1]; ++i) visit(items_[i]);
      }
    }
  }

  const Edge& At(int32_t edge) const { return edges_[static_cast<size_t>(edge)]; }
  Coord square_nm() const { return square_nm_; }
  const Box& bounds() const { return box_; }
  int32_t size() const { return static_cast<int32_t>(edges_.size()); }

  /// Whether the open segment ab meets an edge anywhere. Exact.
  bool Meets(Point a, Point b) const;

 private:
  int32_t Column(Coord x) const;
  int32_t Row(Coord y) const;
  template <typename Visit>
  void ForEachSquare(const Edge& edge, Visit visit) const;

  std::vector<Edge> edges_;
  Box box_;
  Coord square_nm_ = 1;
  int32_t columns_ = 1;
  int32_t rows_ = 1;
  std::vector<int32_t> begin_;  ///< in items_, by square
  std::vector<int32_t> items_;
};

}  // namespace slicefarm
