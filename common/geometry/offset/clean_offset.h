#pragma once

#include <optional>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Result of TryOffset: islands with each edge moved by the offset distance. Edges that have shrunk
/// to nothing are omitted; nothing else has changed.
struct CleanOffset {
  MultiPolygon polygons;
  bool has_tips = false;  ///< true if the result has a convex corner of less than 60 degrees
};

/// Offsets islands edge by edge, and proves that the result is right. Each remaining edge has its
/// old direction. Each removed edge is behind the meeting point of its neighbours. The rings are
/// simple, and nested as before. Corners that the edges move away from are mitered up to twice the
/// distance and cut square beyond, as in Offset. Returns nullopt if a ring would vanish, split,
/// join another ring, or change its shape otherwise; use Offset for these cases.
///
/// Measured at right angles to its edges, the result differs from the result of Offset by at most 2
/// nm. Along the edges, the tips of acute corners may differ by more. Cost: O(n log n) for n edges,
/// about a tenth of a sweep's.
std::optional<CleanOffset> TryOffset(const MultiPolygon& polygons, Coord distance_nm);

/// Shrinks an island, which may split or lose parts. While the boundary moves inwards, each edge
/// covers a rectangle and each reflex corner a miter. The result is the part of the island that
/// remains uncovered, found by the winding numbers of one curve. Returns nullopt if this curve is
/// not in general position. REQUIRES: distance_nm > 0; the island is simple. Cost: see
/// TryWindingRegion; about a fifth of a sweep's.
std::optional<MultiPolygon> TryErode(const PolygonWithHoles& island, Coord distance_nm);

/// Returns Offset(polygons, distance_nm). Uses TryOffset or TryErode if they succeed. To shrink,
/// the islands are handled one by one; to grow, together.
MultiPolygon FastOffset(const MultiPolygon& polygons, Coord distance_nm);

}  // namespace slicefarm
