#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/point.h"

namespace slicefarm::planning {

/// A ring with the places where its seam may be.
struct SeamNode {
  int32_t parent = -1;         ///< the ring below that it follows, which comes before it; -1: none
  std::vector<Point> places;   ///< one at least
  std::vector<double> costs;   ///< how little each of them suits a seam
  /// How far each place lies from all of the ring below: a step to it has that length at least.
  /// Empty: 0.
  std::vector<double> away_mm;
};

/// What it costs that a seam does not stand over that of the ring below. Where a wall leans, a part
/// of each step is not sideways: `away_mm`, how far its end lies from all of the ring below.
struct StepCost {
  double longest_mm = 0.8;  ///< how far a step may go sideways; no step costs more than a jump
  double per_mm = 4;
  double per_mm2_sideways = 4;  ///< several small steps are better than one
  double jump = 40;             ///< of steps further to the side, however far

  bool Reaches(Point from, Point to, double away_mm) const;
  double Of(Point from, Point to, double away_mm) const;
};

/// The choice of a place for each ring that costs least in all: the places' costs, and those of the
/// steps from each ring to its parent. Where an island splits, each part follows it; where islands
/// meet, the ring follows one of them: so rings are trees. Exact, by dynamic programming from the
/// leaves down; the first of equals.
/// Shapes: an index into `places` for each node. Cost: O(places * log places), for places
/// that stand no closer together than steps are long.
std::vector<int32_t> CheapestSeams(std::span<const SeamNode> nodes, const StepCost& step);

}  // namespace slicefarm::planning
