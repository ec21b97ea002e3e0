#pragma once

#include "common/geometry/point.h"

namespace slicefarm::ordering {

/// Obstacle between points that a travel should not cross.
class Barrier {
 public:
  virtual ~Barrier() = default;
  /// Returns true if the straight line from a to b crosses the obstacle. REQUIRES of
  /// implementations: Parts(a, b) == Parts(b, a).
  virtual bool Parts(Point a, Point b) const = 0;
};

}  // namespace slicefarm::ordering
