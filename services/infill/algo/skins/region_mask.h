#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/measure.h"

namespace slicefarm::infill {

/// Coarse raster of a region: the squares of a grid that the region touches. The raster proves at
/// low cost that no edge of an outline is in the region.
class RegionMask {
 public:
  /// Builds the raster. Cost: O(n + squares along the boundary + squares / 64), n points.
  explicit RegionMask(const MultiPolygon& region);

  /// Returns true if an edge of `outlines` may meet the region. If it returns false, each island of
  /// the region is either covered by `outlines` or outside of them. Cost: O(n + squares along the
  /// edges near the region), n points of `outlines`.
  bool MayMeet(const MultiPolygon& outlines) const;

 private:
  /// Calls visit(row, first column, last column) for the squares that an edge passes, row by row,
  /// until a call returns true. Returns true if a call did so.
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
  int32_t words_ = 0;  ///< number of words of bits in a row of squares
  std::vector<uint64_t> bits_;
};

}  // namespace slicefarm::infill
