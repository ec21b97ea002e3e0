#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm {

/// Index of the edges of a region, to find the edges near a point or box. For each square of a
/// grid, it stores the edges that pass the square.
class EdgeIndex {
 public:
  /// Edge of the region. `ring` is the index of its ring, and `edge` the index of its start in the
  /// ring.
  struct Edge {
    Point a, b;  ///< the region is to the left of ab
    int32_t ring = 0;
    int32_t edge = 0;
  };

  /// Makes an index with squares of about `square_nm`, rounded up to a power of two. Squares are
  /// larger if there would be many more squares than edges. Cost: O(edges + squares).
  EdgeIndex(const MultiPolygon& region, Coord square_nm);

  /// Calls visit(number) with the number of each edge near the box: all edges that meet the box,
  /// and possibly further ones. An edge may be visited several times. At(number) is the edge.
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

  /// Returns the edge with the given number.
  const Edge& At(int32_t edge) const { return edges_[static_cast<size_t>(edge)]; }
  Coord square_nm() const { return Coord{1} << square_bits_; }
  const Box& bounds() const { return box_; }
  int32_t size() const { return static_cast<int32_t>(edges_.size()); }

  /// Returns the column of the squares with this x. If x is outside the bounds, returns the nearest
  /// column.
  int32_t Column(Coord x) const { return SquareOf(x, box_.min.x, box_.max.x); }
  /// Returns the row of the squares with this y. If y is outside the bounds, returns the nearest
  /// row.
  int32_t Row(Coord y) const { return SquareOf(y, box_.min.y, box_.max.y); }

  /// Returns true if the open segment ab meets an edge. Exact.
  bool Meets(Point a, Point b) const;

 private:
  int32_t SquareOf(Coord at, Coord least, Coord most) const {
    return static_cast<int32_t>((std::clamp(at, least, most) - least) >> square_bits_);
  }
  template <typename Visit>
  void ForEachSquare(const Edge& edge, Visit visit) const;

  std::vector<Edge> edges_;
  Box box_;
  int square_bits_ = 0;  ///< a square is 2^square_bits_ nm wide, so that no division is needed
  int32_t columns_ = 1;
  int32_t rows_ = 1;
  /// Index in items_ of the first item of each square; one more entry than squares.
  std::vector<int32_t> begin_;
  std::vector<int32_t> items_;
};

}  // namespace slicefarm
