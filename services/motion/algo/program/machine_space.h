#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::motion {

/// Where the nozzle can go.
class MachineSpace {
 public:
  /// `bed`: empty: everywhere; not convex: its box counts. `max_height_mm` 0: no limit.
  MachineSpace(const Polygon& bed, double max_height_mm, double min_height_mm);

  /// How far, in mm, a place lies outside; at most 0: it does not.
  double Outside(double x_mm, double y_mm, double z_mm) const;
  /// The same of a height, wherever it is.
  double OutsideHeight(double z_mm) const;

 private:
  /// a x + b y <= c inside; (a, b) of length 1.
  struct Side {
    double a, b, c;
  };
  std::vector<Side> sides_;
  double max_height_mm_;
  double min_height_mm_;
};

}  // namespace slicefarm::motion
