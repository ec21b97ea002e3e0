#pragma once

#include <optional>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Islands whose edges have moved, without anything happening to them but that edges between two
/// corners towards which they moved vanished.
struct CleanOffset {
  MultiPolygon polygons;
  bool has_tips = false;  ///< a convex corner of less than 60 degrees is left
};

/// Offsets islands edge by edge, and proves the result right: each edge that is left runs as
/// before, those that are not are behind their neighbours' meeting point, the rings are simple and
/// nested as they were. Corners away from which the edges move are mitered up to twice the distance
/// and cut square beyond, as Offset does. nullopt where a ring would vanish, split, join another,
/// or change its shape otherwise; that is what Offset is for.
///
/// The result equals that of Offset to within 2 nm across its edges; along them, the tips of acute
/// corners lie farther apart.
/// Cost: O(n log n), about a tenth of Offset's.
std::optional<CleanOffset> TryOffset(const MultiPolygon& polygons, Coord distance_nm);

/// Shrinks an island whatever happens to it: it may split, and parts of it vanish. Each edge sweeps
/// a rectangle, each reflex corner its miter, and what none of them covers is left; that is read
/// off the winding numbers of one curve. nullopt where that curve is not in general position.
/// REQUIRES: distance_nm > 0; the island is simple. Cost: see TryWindingRegion; about a fifth of
/// Offset's.
std::optional<MultiPolygon> TryErode(const PolygonWithHoles& island, Coord distance_nm);

/// Offset(polygons, distance_nm), by TryOffset or TryErode where these will do: island by island if
/// they shrink, all together if they grow.
MultiPolygon FastOffset(const MultiPolygon& polygons, Coord distance_nm);

}  // namespace slicefarm
