#pragma once

#include <span>

#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm::infill {

/// Share of a region that lies under beads: each as wide as what it fills of a layer `height_nm`
/// high, place by place, with round ends and turns. What lies twice counts once.
///
/// Measured along rows across the region, on which where beads and the region begin and end is
/// exact. Rows lie 1/kRowsPerBead of `spacing_nm` apart, or kMostRows over all of the region,
/// aslant to lines that run along axes, so that no row falls along a bead's edge. Precision: 0.001
/// of regions some beads wide. Cost: O(length of beads * rows + k log k), k places where rows meet
/// edges.
double CoveredShare(const MultiPolygon& region, std::span<const Path> paths, Coord height_nm,
                    Coord spacing_nm);
inline constexpr int kRowsPerBead = 16;
inline constexpr int kMostRows = 20'000;

}  // namespace slicefarm::infill
