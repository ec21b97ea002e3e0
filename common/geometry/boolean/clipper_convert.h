#pragma once

#include <clipper.hpp>

#include "common/geometry/polygon.h"

namespace slicefarm::internal {

/// Clipper's types and ours; private to common/geometry.

ClipperLib::Path ToPath(const std::vector<Point>& points);
std::vector<Point> FromPath(const ClipperLib::Path& path);
void AppendRings(const MultiPolygon& polygons, ClipperLib::Paths& paths);

/// Islands below a node of a tree that Clipper filled, in canonical form.
MultiPolygon FromTree(const ClipperLib::PolyNode& root);

}  // namespace slicefarm::internal
