#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Parameters of HilbertFill and PeanoFill.
struct QuadtreeOptions {
  Coord spacing_nm = 450'000;  ///< spacing of neighbouring lines
  double first_line = 0.5;     ///< distance of the outermost line from the boundary, in spacings
};

/// Fills a region with Hilbert curves. The cells of the curves have a side of two spacings, on a
/// grid through the origin of coordinates, so that copies and layers agree. The cells that are at
/// least one line's distance inside the region form a quadtree. Each leaf of the tree is filled by
/// a ring of four Hilbert curves (Moore's closed form). Lines at constant distances from the cells
/// and from the boundary fill the band between both. LinkRings joins all curves and lines into one
/// path for each connected piece of the region inset by half a spacing. The leaves of the tree are
/// joined in the order of the Hilbert curve.
///
/// Length times spacing is the region's area: exactly in the cells, approximately in the band
/// (RingsFrom).
///
/// Errors: SETTING_OUT_OF_RANGE and REQUEST_TOO_LARGE, see CheckRingSpacing.
absl::StatusOr<std::vector<Polyline>> HilbertFill(const PolygonWithHoles& region,
                                                  const QuadtreeOptions& options);

/// Fills a region like HilbertFill, but with Peano curves: the tree's squares are divided by three
/// per side, and each leaf is a ring of four curves.
absl::StatusOr<std::vector<Polyline>> PeanoFill(const PolygonWithHoles& region,
                                                const QuadtreeOptions& options);

}  // namespace slicefarm::infill
