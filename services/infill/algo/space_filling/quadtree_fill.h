#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Parameters of HilbertFill and PeanoFill.
struct QuadtreeOptions {
  Coord spacing_nm = 450'000;  ///< spacing of neighbouring lines
  double first_line = 0.5;     ///< distance of the outermost line from the edge, in spacings
};

/// Fills a region with Hilbert curves. One curve runs around each leaf of a quadtree of the cells
/// that are at least a line inside (Moore's closed form, four Hilbert curves in a ring). The cells
/// are on a grid of two spacings per side through the origin of coordinates, so that copies and
/// layers agree. The band along the edge is filled by lines of constant depth below the edge and
/// around the cells. LinkRings joins all of them, leaves in the order of the curve, to one path for
/// each part of the region that is connected half a spacing inside.
///
/// Length times spacing is the region's area: exactly in the cells, see RingsFrom for the band.
///
/// Errors: as FermatFill.
absl::StatusOr<std::vector<Polyline>> HilbertFill(const PolygonWithHoles& region,
                                                  const QuadtreeOptions& options);

/// Fills a region like HilbertFill, but with Peano curves: the tree's squares are divided by three
/// per side, and each leaf is a ring of four curves.
absl::StatusOr<std::vector<Polyline>> PeanoFill(const PolygonWithHoles& region,
                                                const QuadtreeOptions& options);

}  // namespace slicefarm::infill
