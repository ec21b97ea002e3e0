#pragma once

#include <span>

#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm::infill {

/// Returns the share of a region that is under beads. Each bead has its local width in a layer of
/// height `height_nm`, with round ends and corners. An area under two beads counts once.
///
/// The share is measured along rows (scan lines) across the region, on which the starts and ends of
/// beads and of the region are exact. Rows are `spacing_nm` / kRowsPerBead apart, or farther if the
/// region would have more than kMostRows. They are oblique to usual fill lines, so that no row
/// follows a bead's edge. Precision: 0.001 for regions some beads wide. Cost: O(length of beads *
/// rows + k log k), k crossings of rows and edges.
double CoveredShare(const MultiPolygon& region, std::span<const Path> paths, Coord height_nm,
                    Coord spacing_nm);
/// Number of rows per spacing.
inline constexpr int kRowsPerBead = 16;
/// Largest number of rows over a region.
inline constexpr int kMostRows = 20'000;

}  // namespace slicefarm::infill
