#pragma once

#include <array>

#include "common/geometry/point.h"

namespace slicefarm {

/// Triangle of an object's surface, seen from above, near one of the object's layers.
struct SurfaceFacet {
  std::array<Point, 3> corners;     ///< corners, counter-clockwise as seen from above
  std::array<Coord, 3> up_nm = {};  ///< heights of the corners above the layer's top

  friend bool operator==(const SurfaceFacet&, const SurfaceFacet&) = default;
};

}  // namespace slicefarm
