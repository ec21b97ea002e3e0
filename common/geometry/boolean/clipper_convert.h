#pragma once

#include <clipper.hpp>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::internal {

/// Clipper's types and ours; private to common/geometry.

ClipperLib::Path ToPath(const std::vector<Point>& points);
std::vector<Point> FromPath(const ClipperLib::Path& path);
void AppendRings(const MultiPolygon& polygons, ClipperLib::Paths& paths);

/// Islands below a node of a tree that Clipper filled, in canonical form. Where edges touch,
/// Clipper 6 forgets now and then which island a hole lies in, and lists the hole as an island, or
/// below another one. Then rings go by their sense and place, as in FromRings.
MultiPolygon FromTree(const ClipperLib::PolyNode& root);

/// Islands and holes by the sense of rings that do not cross, in canonical form: each hole is in
/// the innermost island around it. Cost: O(islands * points of holes * points of islands).
MultiPolygon FromRings(std::vector<Polygon> rings);

}  // namespace slicefarm::internal
