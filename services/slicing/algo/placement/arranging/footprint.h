#pragma once

#include <compare>
#include <span>
#include <utility>
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

/// A copy: which of the parts it belongs to, and which of that part's copies it is.
struct CopyOf {
  size_t part = 0;
  size_t copy = 0;

  friend auto operator<=>(const CopyOf&, const CopyOf&) = default;
};

/// Every two copies whose footprints have area in common, each two in ascending order, all of them
/// sorted. Hulls may overlap where parts do not, such as two brackets one in the corner of the
/// other. Cost: O(c log c) for c copies in a row whose boxes are apart; a boolean operation for
/// each two whose boxes overlap.
std::vector<std::pair<CopyOf, CopyOf>> OverlappingFootprints(std::span<const Copies> parts);

}  // namespace slicefarm::slicing
