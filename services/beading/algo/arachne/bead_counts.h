#pragma once

#include <functional>
#include <vector>

#include "common/geometry/skeleton/skeletal_graph.h"
#include "common/geometry/vector.h"
#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Smallest distance in nm between a new node on an edge and each end of this edge.
inline constexpr double kLeastPieceNm = 10'000;

/// Options for PlanBeadCounts.
struct CountOptions {
  /// Largest change of a bead's width, in nm, by which a transition between two numbers of beads
  /// may be avoided.
  double filter_deviation_nm = 100'000;
  /// Length in nm of the longest span that may get another number of beads to avoid a
  /// transition.
  double filter_distance_nm = 100'000'000;
  /// Function that returns the radius from which the number of beads is chosen at a position.
  /// `place`: the position in the graph's coordinates. `radius_nm`: the radius at this position. It
  /// is only called if the thickness, which is twice the radius, differs from a transition by less
  /// than `filter_deviation_nm`. If empty, `radius_nm` is used.
  std::function<double(Vector2 place, double radius_nm)> deciding_radius = nullptr;
};

/// Number of beads across a node: `count` + `ratio`. The ratio is above 0 only within a transition
/// from `count` beads to one more; it is the share of the additional bead.
struct BeadCount {
  int count = -1;  ///< -1: not decided here, because the node copies the beads of other nodes
  double ratio = 0;

  /// Returns true if the number is decided at this node.
  bool decided() const { return count >= 0; }
  friend bool operator==(const BeadCount&, const BeadCount&) = default;
};

/// Decides the number of beads along the central edges and at isolated tops. A top is a node with a
/// locally largest radius; it is isolated if none of its edges is central. The result is indexed by
/// node.
///
/// Edges are split at the start, middle and end of transitions and at the thicknesses of
/// BeadingStrategy::Kinks; `central` grows with the edges. A span is a set of connected central
/// edges with the same number of beads. A span is merged into a neighbouring span if this
/// changes widths by less than the filter in `options` allows; the shortest span is merged
/// first. Cost: O(n log n), n edges.
///
/// Source: Kuipers et al. 2020, section 3.3. Unlike there, the number of beads in a transition
/// follows from the distance to all nearby transitions.
std::vector<BeadCount> PlanBeadCounts(const BeadingStrategy& strategy, const CountOptions& options,
                                      SkeletalGraph& graph, std::vector<char>& central);

}  // namespace slicefarm::beading
