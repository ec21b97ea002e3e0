#pragma once

#include <compare>
#include <span>
#include <utility>
#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/scene/mesh.h"

namespace slicefarm::slicing {

/// Returns the convex hull of meshes seen from above, counter-clockwise. A hull without area has
/// fewer than three points. Cost: O(n), plus O(h log h) for the h vertices that are not well
/// inside.
Polygon Footprint(std::span<const IndexedMesh* const> meshes);

/// Footprint of a part, and the positions of the part's copies.
struct Copies {
  const Polygon* footprint = nullptr;
  std::span<const Point> centers;
};

/// Reference to a copy: index of its part, and index among the copies of that part.
struct CopyOf {
  size_t part = 0;
  size_t copy = 0;

  friend auto operator<=>(const CopyOf&, const CopyOf&) = default;
};

/// Returns all pairs of copies with footprints that overlap in an area. Each pair is in ascending
/// order, and the list is sorted. Hulls may overlap even if the parts do not, for example two
/// brackets of which one is in the corner of the other. Cost: O(c log c) for c copies in a row with
/// separate boxes; a boolean operation for each pair with overlapping boxes.
std::vector<std::pair<CopyOf, CopyOf>> OverlappingFootprints(std::span<const Copies> parts);

}  // namespace slicefarm::slicing
