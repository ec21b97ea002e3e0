#pragma once

#include <clipper.hpp>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::internal {

// Conversions between Clipper's types and slicefarm's types; private to common/geometry.

ClipperLib::Path ToPath(const std::vector<Point>& points);
std::vector<Point> FromPath(const ClipperLib::Path& path);
void AppendRings(const MultiPolygon& polygons, ClipperLib::Paths& paths);

/// Returns the islands below a node of a tree that Clipper filled, in canonical form. Where edges
/// touch, Clipper 6 sometimes assigns a hole to no island or to a wrong one, or lists it as an
/// island. In this case the rings are assigned by their direction and position, as in FromRings.
MultiPolygon FromTree(const ClipperLib::PolyNode& root);

/// Returns islands and holes in canonical form, by the direction of the rings. Each hole belongs to
/// the innermost island around it. REQUIRES: the rings do not cross. Cost: O(islands * points of
/// holes * points of islands).
MultiPolygon FromRings(std::vector<Polygon> rings);

}  // namespace slicefarm::internal
