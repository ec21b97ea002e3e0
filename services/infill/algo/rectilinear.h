#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/model/infill_options.h"
#include "common/model/path.h"

namespace slicefarm::infill {

struct SparseFill {
  SparsePattern pattern = SparsePattern::kGrid;
  double density = 0.2;  ///< (0, 1]
  double angle_rad = 0;
  int32_t layer_index = 0;  ///< rectilinear lines turn by a right angle from layer to layer
  Coord width_nm = 450'000;
  Coord height_nm = 200'000;
  Coord overlap_nm = 0;  ///< how much nearer than half a spacing lines come to the region's edge
};

/// Fills a region with straight lines of the given density: path length per area is density /
/// spacing, exactly. So the pitch is spacing / density, and twice that for each of the two
/// directions of a grid.
///
/// Lines lie on one grid, a quarter pitch beside the origin, the same for all layers, islands and
/// regions. Ends that are neighbours along the edge are joined, the nearest first, as long as that
/// does not bring the region's length more than 3 % over what the density asks for.
///
/// Errors: as CutLines. Cost: O(n log n) for the inset, O(n + k) for the lines.
/// Source: the spacing law is that of every slicer; see also "density" in tests.
absl::StatusOr<std::vector<Path>> FillSparse(const MultiPolygon& region, const SparseFill& fill);

}  // namespace slicefarm::infill
