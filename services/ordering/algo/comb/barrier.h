#pragma once

#include "common/geometry/point.h"

namespace slicefarm::ordering {

/// What lies between places.
class Barrier {
 public:
  virtual ~Barrier() = default;
  /// Returns true if the straight way from a to b crosses it. REQUIRES: symmetric.
  virtual bool Parts(Point a, Point b) const = 0;
};

}  // namespace slicefarm::ordering
