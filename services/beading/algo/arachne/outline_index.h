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

  /// Returns the distance in nm from the point (x, y) to the nearest outline; infinity if there is
  /// none within `limit_nm`. Cost: O(edges in the square of side 2 `limit_nm` around the point).
  double DistanceFrom(double x, double y, double limit_nm) const;

 private:
  EdgeIndex edges_;
};

}  // namespace slicefarm::beading
