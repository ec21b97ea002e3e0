#pragma once

#include <functional>
#include <vector>

#include "common/geometry/skeleton/skeletal_graph.h"
#include "common/geometry/vector.h"
#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Nodes nearer than this to another one are not made.
inline constexpr double kLeastPieceNm = 10'000;

struct CountOptions {
  double filter_deviation_nm = 100'000;     ///< how much wider or narrower beads may get ...
  double filter_distance_nm = 100'000'000;  ///< ... along a stretch this long, to save a transition
  /// The radius by which counts are decided where the own one, `radius_nm` at a place, is nearer to
  /// a transition's than `filter_deviation_nm`; none: always the own one.
  std::function<double(Vector2 place, double radius_nm)> deciding_radius = nullptr;
};

/// How many beads lie across a node: `count`, or in a transition more than that by `ratio` of one.
struct BeadCount {
  int count = -1;  ///< -1: not decided here, but by the places around
  double ratio = 0;

  bool decided() const { return count >= 0; }
  friend bool operator==(const BeadCount&, const BeadCount&) = default;
};

/// Decides the number of beads along the central edges and at the tops that stand alone. Edges are
/// split where transitions begin, lie and end, and where the strategy has kinks; `central` grows
/// with them. By node. Stretches that differ from the one beside them by less than the filter are
/// taken into it, the shortest first. Cost: O(n log n).
/// Source: Kuipers et al. 2020, section 3.3; ramps as a field of distances from all transitions.
std::vector<BeadCount> PlanBeadCounts(const BeadingStrategy& strategy, const CountOptions& options,
                                      SkeletalGraph& graph, std::vector<char>& central);

}  // namespace slicefarm::beading
