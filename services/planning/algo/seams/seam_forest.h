#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/point.h"

namespace slicefarm::planning {

/// Ring of a layer, with the possible points of its seam.
struct SeamNode {
  /// Index in the list of nodes of the ring in the layer below that this ring continues. It is
  /// smaller than the ring's own index; -1: none.
  int32_t parent = -1;
  std::vector<Point> candidates;  ///< possible points of the seam; at least one
  std::vector<double> costs;      ///< cost of a seam at each point
  /// Distance of each point from the whole ring below, in mm; empty: 0. A step from the seam below
  /// to the point is at least this long.
  std::vector<double> away_mm;
};

/// Cost of a step: the distance between the seam of a ring and the seam of the ring below. Where a
/// wall leans, a part of the step cannot be avoided: `away_mm`, the distance of the step's end from
/// the whole ring below. The other part is the sideways part.
struct StepCost {
  /// longest sideways part of a step that is no jump
  double longest_mm = 0.8;
  double per_mm = 4;
  double per_mm2_sideways = 4;  ///< makes several small steps cheaper than one large step
  double jump = 40;             ///< cost of a jump, and upper limit for the cost of other steps

  /// Returns true if the sideways part of the step is at most longest_mm.
  bool Reaches(Point from, Point to, double away_mm) const;
  /// Returns the cost of a step. `away_mm`: distance of `to` from the whole ring below.
  double Of(Point from, Point to, double away_mm) const;
};

/// Chooses one point per ring so that the total cost is smallest: the costs of the points, and of
/// the steps from each ring to its parent. Returns the chosen index in `candidates` for each node.
///
/// Where an island splits, each piece follows the ring below. Where islands merge, the ring follows
/// one of them. So the rings form trees, with the roots in the lowest layers. The result is exact,
/// by dynamic programming from the leaves to the roots. Of equal choices the first is taken. Cost:
/// O(n log n) for n points, if the points of a ring are at least StepCost::longest_mm apart.
std::vector<int32_t> CheapestSeams(std::span<const SeamNode> nodes, const StepCost& step);

}  // namespace slicefarm::planning
