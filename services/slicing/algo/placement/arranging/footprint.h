#pragma once

#include <span>
#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/scene/mesh.h"

namespace slicefarm::slicing {

/// The convex hull of meshes as seen from above, counter-clockwise. Fewer than three points if it
/// has no area. Cost: O(n), and O(h log h) for the h vertices that are not well inside.
Polygon Footprint(std::span<const IndexedMesh* const> meshes);

/// A footprint, and where the copies of what it belongs to stand.
struct Copies {
  const Polygon* footprint = nullptr;
  std::span<const Point> centers;
};

/// For each of `parts`, how many of its copies stand on the footprint of another copy or part.
/// Hulls may overlap where parts do not, such as two brackets one in the corner of the other: this
/// is for a warning. Footprints that only touch do not overlap. Cost: O(c log c) for c copies in a
/// row whose boxes are apart; a boolean operation for each two whose boxes overlap.
std::vector<int64_t> CountOverlapping(std::span<const Copies> parts);

}  // namespace slicefarm::slicing
