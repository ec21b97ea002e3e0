#pragma once

#include <vector>

#include "common/geometry/skeleton/skeletal_graph.h"

namespace slicefarm::beading {

/// Options for CentralEdges.
struct CentralityOptions {
  /// Angle in radians; edges are central if their sides meet at a smaller angle.
  double transition_angle = 0.1745;
  double min_radius_nm = 50'000;  ///< smallest radius of a central edge
  /// Ends of central lines that are shorter than this are not central.
  double min_length_nm = 20'000;
};

/// Returns for each edge (half-edge / 2) if it is central: the beads on its two sides face each
/// other, because the sides meet at less than the transition angle. Cost: O(n), n edges. Source:
/// Kuipers et al. 2020, section 3.2.
std::vector<char> CentralEdges(const SkeletalGraph& graph, const CentralityOptions& options);

}  // namespace slicefarm::beading
