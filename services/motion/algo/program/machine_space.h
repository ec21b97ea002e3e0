#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::motion {

/// Space that the nozzle can reach.
class MachineSpace {
 public:
  /// `bed`: in nm; an empty bed is unlimited, and a bed that is not convex is replaced by its
  /// bounding box. `max_height_mm`: 0 means no limit.
  MachineSpace(const Polygon& bed, double max_height_mm, double min_height_mm);

  /// Returns the distance in mm by which a point violates the space's limits; at most 0 inside. At
  /// a corner of the bed, it is the larger of the distances from the two sides.
  double Outside(double x_mm, double y_mm, double z_mm) const;
  /// Returns the distance in mm by which a height is above or below the space; at most 0 inside.
  double OutsideHeight(double z_mm) const;

 private:
  /// Line along a side of the bed: a x + b y <= c for points inside, in mm; (a, b) has length 1.
  struct Side {
    double a, b, c;
  };
  std::vector<Side> sides_;
  double max_height_mm_;
  double min_height_mm_;
};

}  // namespace slicefarm::motion
