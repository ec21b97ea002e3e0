#pragma once

#include <optional>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Islands after each edge was moved. Nothing else has changed, except that some edges between two
/// corners have shrunk to nothing and are omitted.
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
/// The result equals that of Offset to within 2 nm across its edges; along them, the tips of acute
/// corners lie farther apart.
/// Cost: O(n log n), about a tenth of a sweep's.
std::optional<CleanOffset> TryOffset(const MultiPolygon& polygons, Coord distance_nm);

/// Shrinks an island, which may split or lose parts. Each edge sweeps a rectangle and each reflex
/// corner its miter. The uncovered rest is the result, found by the winding numbers of one curve.
/// Returns nullopt if this curve is not in general position. REQUIRES: distance_nm > 0; the island
/// is simple. Cost: see TryWindingRegion; about a fifth of a sweep's.
std::optional<MultiPolygon> TryErode(const PolygonWithHoles& island, Coord distance_nm);

/// Returns Offset(polygons, distance_nm), calculated by TryOffset or TryErode if they succeed.
/// Islands are handled one by one if they shrink, and together if they grow.
MultiPolygon FastOffset(const MultiPolygon& polygons, Coord distance_nm);

}  // namespace slicefarm
