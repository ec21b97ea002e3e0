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

  /// Returns how far the nearest outline is, in nm; infinity if there is none within `limit_nm`.
  /// Cost: that of the edges in a square of the limit around the place.
  double DistanceFrom(double x, double y, double limit_nm) const;

 private:
  EdgeIndex edges_;
};

}  // namespace slicefarm::beading
