#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/measure.h"

namespace slicefarm::infill {

/// A coarse picture of a region, which tells cheaply that something does not meet it: the squares
/// of a grid that the region touches.
class RegionMask {
 public:
  /// Cost: O(n + squares along the boundary + squares / 64).
  explicit RegionMask(const MultiPolygon& region);

  /// False only if no edge of `outlines` meets the region: each of its islands is then either
  /// covered by `outlines` or outside of them. Cost: O(n + squares along those edges that come
  /// near).
  bool MayMeet(const MultiPolygon& outlines) const;

 private:
  /// Calls visit(row, first column, last column) for the squares that an edge passes, one row after
  /// the other, until it returns true; returns whether it did.
  template <typename Visit>
  bool ForEachSpan(Point a, Point b, Visit visit) const;

  bool RingMeets(const Polygon& ring) const;
  void MarkBoundary(const Polygon& ring);
  void MarkInside(const MultiPolygon& region);
  void MarkSpan(int32_t row, int32_t first, int32_t last);
  bool AnyInSpan(int32_t row, int32_t first, int32_t last) const;

  Box box_;
  double squares_per_nm_ = 0;
  int32_t rows_ = 0;
  int32_t columns_ = 0;
  int32_t words_ = 0;  ///< a row
  std::vector<uint64_t> bits_;
};

}  // namespace slicefarm::infill
