#pragma once

#include <cstddef>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Shortest paths that stay within a region, such as a bed without its excluded areas.
///
/// Paths bend near the corners that point into the region, at a distance of 0.5 mm. The algorithm
/// tests all corners, so it is only suitable for regions with few corners. Source: T. Lozano-Perez,
/// M. A. Wesley, "An Algorithm for Planning Collision-Free Paths among Polyhedral Obstacles", CACM
/// 22 (1979).
class PathsWithin {
 public:
  /// Prepares paths within `region`. An empty region has no obstacles. Cost: O(n^3) for n corners.
  explicit PathsWithin(const MultiPolygon& region);

  /// Returns the corners of the shortest path from a to b within the region. The result is empty if
  /// the straight line is within the region, if a or b is outside the region, or if there is no
  /// path. Cost, for n corners of the region: O(n) if the straight line is within the region;
  /// otherwise O(n^2).
  std::vector<Point> Between(Point a, Point b) const;

 private:
  /// Shortest paths from one point to all bends (points at which paths may bend).
  struct Tree {
    /// Length of the path to each bend, in nm; infinite if there is no path.
    std::vector<double> length;
    /// Index of the bend before each bend on its path; the number of all bends if there is none.
    std::vector<size_t> before;
  };

  bool Sees(Point a, Point b) const;
  Tree PathsFrom(Point a) const;

  MultiPolygon region_;       ///< the region, grown slightly, so that paths may follow its boundary
  std::vector<Point> bends_;  ///< points at which paths may bend
  /// Lengths of the straight lines between pairs of bends, in nm; infinite if the line leaves the
  /// region.
  std::vector<std::vector<double>> lengths_;
};

}  // namespace slicefarm
