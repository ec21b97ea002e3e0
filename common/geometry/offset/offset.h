#pragma once

#include <span>

#include "common/geometry/polygon.h"

namespace slicefarm {

enum class Join { kMiter, kRound, kSquare };
enum class Cap { kButt, kSquare, kRound };

/// Join style of an offset, and its limits.
struct OffsetOptions {
  Join join = Join::kMiter;
  /// Miter limit: miters longer than this multiple of the offset distance are cut square. The
  /// smallest useful value is 1.
  double miter_limit = 2.0;
  /// Largest distance of a round join from the true arc.
  Coord arc_tolerance_nm = 2'500;
};

/// Grows (distance > 0) or shrinks (< 0) a region. Rings that shrink to nothing vanish: a unit
/// square inset by 0.6 is empty. The result is in canonical form. Cost: that of TryWindingRegion;
/// if it fails, in addition O(n log n) for n edges and a union by Clipper.
MultiPolygon Offset(const MultiPolygon& polygons, Coord distance_nm,
                    const OffsetOptions& options = {});

/// Offsets by `first_nm` and then by `second_nm`. (-d, +d) is an opening, (+d, -d) is a closing.
MultiPolygon OffsetTwice(const MultiPolygon& polygons, Coord first_nm, Coord second_nm,
                         const OffsetOptions& options = {});

/// Returns the region within `distance_nm` of open lines. REQUIRES: distance_nm > 0.
MultiPolygon OffsetLines(std::span<const Polyline> lines, Coord distance_nm, Cap cap,
                         const OffsetOptions& options = {});

}  // namespace slicefarm
