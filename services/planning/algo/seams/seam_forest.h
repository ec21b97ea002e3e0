#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/point.h"

namespace slicefarm::planning {

/// Ring with the possible points of its seam.
struct SeamNode {
  /// Index of the ring below that this ring follows, always an earlier index; -1: none.
  int32_t parent = -1;
  std::vector<Point> places;  ///< possible points of the seam; at least one
  std::vector<double> costs;  ///< cost of a seam at each point
  /// Distance of each point from the whole ring below, in mm. A step to the point is at least this
  /// long. An empty vector means 0.
  std::vector<double> away_mm;
};

/// Cost of a seam that is not directly above the seam of the ring below. Where a wall leans, only a
/// part of the step is sideways. The other part is `away_mm`, the distance of the step's end from
/// the whole ring below.
struct StepCost {
  /// longest sideways part of a step; steps up to this length cost at most as much as a jump
  double longest_mm = 0.8;
  double per_mm = 4;
  double per_mm2_sideways = 4;  ///< makes several small steps cheaper than one large step
  double jump = 40;             ///< cost of a jump: a step with a longer sideways part

  /// Returns true if the sideways part of the step is at most longest_mm.
  bool Reaches(Point from, Point to, double away_mm) const;
  /// Returns the cost of a step.
  double Of(Point from, Point to, double away_mm) const;
};

/// Chooses one point per ring, and returns its index in `places` for each node, so that the total
/// cost is smallest: the costs of points, and of the steps from each ring to its parent. Where an
/// island splits, each piece follows it. Where islands merge, the ring follows one of them. So the
/// rings form trees. The result is exact, by dynamic programming from the leaves down. Of equal
/// choices the first is taken. Cost: O(n log n) for n points, if the points of a ring are at least
/// StepCost::longest_mm apart.
std::vector<int32_t> CheapestSeams(std::span<const SeamNode> nodes, const StepCost& step);

}  // namespace slicefarm::planning
