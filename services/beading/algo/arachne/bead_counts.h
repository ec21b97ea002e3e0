#pragma once

#include <functional>
#include <vector>

#include "common/geometry/skeleton/skeletal_graph.h"
#include "common/geometry/vector.h"
#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Smallest distance of a new node from an existing one.
inline constexpr double kLeastPieceNm = 10'000;

/// Options for PlanBeadCounts.
struct CountOptions {
  /// Largest change of a bead's width that saves a transition.
  double filter_deviation_nm = 100'000;
  /// Largest length of a stretch that is changed to save a transition.
  double filter_distance_nm = 100'000'000;
  /// Function that returns the radius for close decisions, from a position and its own radius
  /// `radius_nm`. It is used if the thickness is within `filter_deviation_nm` of a transition.
  /// None: the own radius always decides.
  std::function<double(Vector2 place, double radius_nm)> deciding_radius = nullptr;
};

/// Number of beads across a node: `count`, plus the fraction `ratio` of one bead in a transition.
struct BeadCount {
  int count = -1;  ///< -1: not decided here, but by the nodes around
  double ratio = 0;

  /// Returns true if the number is decided at this node.
  bool decided() const { return count >= 0; }
  friend bool operator==(const BeadCount&, const BeadCount&) = default;
};

/// Decides the number of beads along the central edges and at isolated tops, which are nodes with a
/// locally largest radius. The result is per node.
///
/// Edges are split at the start, middle and end of transitions and at the kinks of the strategy;
/// `central` grows with them. A stretch is a connected part with one count. Stretches that differ
/// from a neighbour by less than the filter are merged into it, the shortest first. Cost: O(n log
/// n).
///
/// Source: Kuipers et al. 2020, section 3.3; here the ramps are a field of distances from all
/// transitions.
std::vector<BeadCount> PlanBeadCounts(const BeadingStrategy& strategy, const CountOptions& options,
                                      SkeletalGraph& graph, std::vector<char>& central);

}  // namespace slicefarm::beading
