#pragma once

#include <limits>

#include "common/geometry/edge_index.h"
#include "common/geometry/polygon.h"

namespace slicefarm::beading {

/// Index of outlines for distance queries.
class OutlineIndex {
 public:
  /// Builds the index. Cost: O(n), n edges.
  explicit OutlineIndex(const MultiPolygon& outlines);

  /// Returns the distance of the position (x, y) from the nearest outline, in nm; infinity if it is
  /// more than `limit_nm`. Cost: O(number of edges in a square with half the side `limit_nm` around
  /// the position).
  double DistanceFrom(double x, double y, double limit_nm) const;

 private:
  EdgeIndex edges_;
};

}  // namespace slicefarm::beading
