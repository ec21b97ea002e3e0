#pragma once

#include <functional>
#include <vector>

#include "common/geometry/skeleton/skeletal_graph.h"
#include "common/geometry/vector.h"
#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Smallest distance in nm of a new node from an existing one.
inline constexpr double kLeastPieceNm = 10'000;

/// Options for PlanBeadCounts.
struct CountOptions {
  /// Largest change of a bead's width, in nm, that is accepted to avoid a transition between two
  /// numbers of beads.
  double filter_deviation_nm = 100'000;
  /// Largest length in nm of a stretch with a changed number of beads, to avoid a transition.
  double filter_distance_nm = 100'000'000;
  /// Function that returns the radius that decides between two numbers of beads, for a position
  /// with the radius `radius_nm` of its own. It is used if the thickness is within
  /// `filter_deviation_nm` of a transition. None: `radius_nm` always decides.
  std::function<double(Vector2 place, double radius_nm)> deciding_radius = nullptr;
};

/// Number of beads across a node: `count`, plus the fraction `ratio` of one bead in a transition.
struct BeadCount {
  int count = -1;  ///< -1: not decided at this node, but by its neighbours
  double ratio = 0;

  /// Returns true if the number is decided at this node.
  bool decided() const { return count >= 0; }
  friend bool operator==(const BeadCount&, const BeadCount&) = default;
};

/// Decides the number of beads along the central edges and at isolated tops, which are nodes with a
/// locally largest radius. The result is indexed by node.
///
/// Edges are split at the start, middle and end of transitions and at the thicknesses of
/// BeadingStrategy::Kinks; `central` grows with the edges. A stretch is a connected part with one
/// number of beads. Stretches that differ from a neighbour by less than the filter (`options`) are
/// merged into this neighbour, the shortest first. Cost: O(n log n), n edges.
///
/// Source: Kuipers et al. 2020, section 3.3; here the ramps are a field of distances from all
/// transitions.
std::vector<BeadCount> PlanBeadCounts(const BeadingStrategy& strategy, const CountOptions& options,
                                      SkeletalGraph& graph, std::vector<char>& central);

}  // namespace slicefarm::beading
