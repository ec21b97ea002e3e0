#pragma once

#include <vector>

#include "common/geometry/skeleton/skeletal_graph.h"

namespace slicefarm::beading {

/// Options for CentralEdges.
struct CentralityOptions {
  /// Angle in radians. An edge is central if the two sides of the outline beside it meet at a
  /// smaller angle.
  double transition_angle = 0.1745;
  /// an edge is central only if the radius at one of its ends is at least this
  double min_radius_nm = 50'000;
  /// A line of central edges shorter than this is not central if it has a free end and joins other
  /// central edges at the opposite end.
  double min_length_nm = 20'000;
};

/// Returns for each edge (index of a half-edge / 2) 1 if it is central, else 0. Beads on the two
/// sides of a central edge face each other, because the sides of the outline meet there at less
/// than the transition angle. Cost: O(n), n edges. Source: Kuipers et al. 2020, section 3.2.
std::vector<char> CentralEdges(const SkeletalGraph& graph, const CentralityOptions& options);

}  // namespace slicefarm::beading
