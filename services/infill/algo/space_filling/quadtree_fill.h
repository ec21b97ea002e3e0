#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"

namespace slicefarm::infill {

struct QuadtreeOptions {
  Coord spacing_nm = 450'000;  ///< of neighbouring lines
  double first_line = 0.5;     ///< how far inside the edge the outermost lies, in spacings
};

/// Fills a region with Hilbert curves: one runs round each leaf of a quadtree of the cells that lie
/// a line and more inside (Moore's closed form, four Hilbert curves in a ring), the cells of a grid
/// of two spacings a side through the origin of coordinates, so that copies and layers agree. What
/// is left along the edge is filled by lines of constant depth below that edge and around the
/// cells. All are joined by LinkRings, leaves in the order of the curve: to one path for each part
/// of the region that is connected half a spacing inside.
///
/// Length times spacing is the region's area: exactly in the cells, see RingsFrom for the band.
///
/// Errors: as FermatFill.
absl::StatusOr<std::vector<Polyline>> HilbertFill(const PolygonWithHoles& region,
                                                  const QuadtreeOptions& options);

/// The same with Peano curves on a tree whose squares are divided by three a side, each leaf a ring
/// of four.
absl::StatusOr<std::vector<Polyline>> PeanoFill(const PolygonWithHoles& region,
                                                const QuadtreeOptions& options);

}  // namespace slicefarm::infill
