#pragma once

#include <span>
#include <vector>

#include "services/infill/algo/scan_lines.h"

namespace slicefarm::infill {

struct EdgeLinkOptions {
  double max_link_nm = 0;     ///< ends farther apart along the edge are not joined
  double link_budget_nm = 0;  ///< length of all links together
  double min_length_nm = 0;   ///< shorter paths are left out
};

/// Joins the pieces of one or more families of scan lines to long paths, along the edge of the
/// region between ends that are neighbours there, of whatever family: the nearest first, as far as
/// the budget goes, and never to a ring.
///
/// REQUIRES: all families were cut from the same region.
/// Every piece is in exactly one path, and no stretch of the edge is used twice.
/// Cost: O(n + k log k), n points of the region, k pieces.
std::vector<Polyline> LinkAlongEdge(std::span<const ScanLines> families,
                                    const EdgeLinkOptions& options);

}  // namespace slicefarm::infill
