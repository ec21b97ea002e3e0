#pragma once

#include <algorithm>
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

  /// Squares of about `square_nm` (the next power of two), or larger where they would be many more
  /// than edges.
  /// Cost: O(edges + squares).
  EdgeIndex(const MultiPolygon& region, Coord square_nm);

  /// Calls visit(edge number) for all edges that may come within the box, each once or more.
  template <typename Visit>
  void ForEachNear(const Box& box, Visit visit) const {
    const int32_t left = Column(box.min.x), right = Column(box.max.x);
    const int32_t bottom = Row(box.min.y), top = Row(box.max.y);
    for (int32_t row = bottom; row <= top; ++row) {
      for (int32_t column = left; column <= right; ++column) {
        const auto square = static_cast<size_t>(row) * columns_ + column;
        for (int32_t i = begin_[square]; i < begin_[square + 1]; ++i) visit(items_[i]);
      }
    }
  }

  const Edge& At(int32_t edge) const { return edges_[static_cast<size_t>(edge)]; }
  Coord square_nm() const { return Coord{1} << square_bits_; }
  const Box& bounds() const { return box_; }
  int32_t size() const { return static_cast<int32_t>(edges_.size()); }

  /// The square in which a place lies; of places outside of the bounds the nearest one.
  int32_t Column(Coord x) const { return SquareOf(x, box_.min.x, box_.max.x); }
  int32_t Row(Coord y) const { return SquareOf(y, box_.min.y, box_.max.y); }

  /// Whether the open segment ab meets an edge anywhere. Exact.
  bool Meets(Point a, Point b) const;

 private:
  int32_t SquareOf(Coord at, Coord least, Coord most) const {
    return static_cast<int32_t>((std::clamp(at, least, most) - least) >> square_bits_);
  }
  template <typename Visit>
  void ForEachSquare(const Edge& edge, Visit visit) const;

  std::vector<Edge> edges_;
  Box box_;
  int square_bits_ = 0;  ///< a square is 2^bits nm wide: no division to find one
  int32_t columns_ = 1;
  int32_t rows_ = 1;
  std::vector<int32_t> begin_;  ///< in items_, by square
  std::vector<int32_t> items_;
};

}  // namespace slicefarm
