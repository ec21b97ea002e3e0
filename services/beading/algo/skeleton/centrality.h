#pragma once

#include <vector>

#include "common/geometry/skeleton/skeletal_graph.h"

namespace slicefarm::beading {

struct CentralityOptions {
  double transition_angle = 0.1745;  ///< radians: sides that meet at less are central
  double min_radius_nm = 50'000;     ///< thinner places are not
  double min_length_nm = 20'000;     ///< ends of central lines that are shorter are not
};

/// For each edge (half-edge / 2), whether the beads on its two sides face each other there: the
/// sides meet at less than the transition angle. Cost: O(n).
/// Source: Kuipers et al. 2020, section 3.2.
std::vector<char> CentralEdges(const SkeletalGraph& graph, const CentralityOptions& options);

}  // namespace slicefarm::beading
