#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::motion {

/// Space that the nozzle can reach.
class MachineSpace {
 public:
  /// `bed`: an empty bed is unlimited, and a bed that is not convex is replaced by its box.
  /// `max_height_mm`: 0 is no limit.
  MachineSpace(const Polygon& bed, double max_height_mm, double min_height_mm);

  /// Returns how far a point is outside the space, in mm; at most 0 inside.
  double Outside(double x_mm, double y_mm, double z_mm) const;
  /// Returns how far a height is outside the space, in mm, at any x and y.
  double OutsideHeight(double z_mm) const;

 private:
  /// Side of the bed: a x + b y <= c inside, with (a, b) of length 1.
  struct Side {
    double a, b, c;
  };
  std::vector<Side> sides_;
  double max_height_mm_;
  double min_height_mm_;
};

}  // namespace slicefarm::motion
