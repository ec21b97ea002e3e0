#pragma once

#include <cstddef>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Shortest ways that stay within a region, such as a bed without its excluded areas.
///
/// Ways bend at the corners that point into the region, 0.5 mm off them. All corners are looked at,
/// so regions of few corners are meant.
/// Source: T. Lozano-Perez, M. A. Wesley, "An Algorithm for Planning Collision-Free Paths among
/// Polyhedral Obstacles", CACM 22 (1979).
class WaysWithin {
 public:
  /// Without a region nothing is in the way. Cost: O(n^3) for the n corners.
  explicit WaysWithin(const MultiPolygon& region);

  /// Returns the corners of the shortest way from a to b within the region; none if the straight
  /// way is one, if a or b lies outside of the region, or if no way leads there.
  /// Cost: O(n) if the straight way is one; else O(n^2).
  std::vector<Point> Between(Point a, Point b) const;

 private:
  /// The shortest ways from a place to the bends.
  struct Tree {
    std::vector<double> length;  ///< in nm; infinite: no way
    std::vector<size_t> before;  ///< the bend before; their count: none
  };

  bool Sees(Point a, Point b) const;
  Tree WaysFrom(Point a) const;

  MultiPolygon region_;       ///< grown by a hair: ways may run along its edge
  std::vector<Point> bends_;  ///< where ways may bend
  std::vector<std::vector<double>> lengths_;  ///< between bends, in nm; infinite: out of sight
};

}  // namespace slicefarm
