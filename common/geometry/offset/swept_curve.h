#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::internal {

/// Curve of a ring's edges after each has moved inwards. Private to common/geometry.
struct SweptCurve {
  Polygon points;
  /// Part of the ring that the curve's edge after each point belongs to: 2 i for the ring's edge i,
  /// 2 i + 1 for the corner after it. The number of the ring's parts is 2 * edges.
  std::vector<int32_t> parts;
  int32_t edges = 0;  ///< number of the ring's edges that have a length
};

/// Returns the curve of a ring's edges after each moves left by `distance_nm` on its own, starting
/// at the outline. The winding numbers of the curve are the island's winding numbers, minus one for
/// each rectangle that an edge sweeps. At each reflex corner, one is also subtracted for the shape
/// between two rectangles. This shape is a miter, or an arc if `arc_tolerance_nm` is given: its
/// chords are at most that far from the arc. Arcs that a miter exceeds by less than a micrometre
/// are miters.
///
/// At a convex corner of 90 degrees or more, two rectangles overlap. The overlap is subtracted only
/// once there, so that the curve does not cross itself at every corner. The curve is empty if the
/// ring reverses its direction somewhere.
SweptCurve SweepInwards(const Polygon& ring, double distance_nm,
                        std::optional<double> arc_tolerance_nm = std::nullopt);

}  // namespace slicefarm::internal
