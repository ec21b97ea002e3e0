#pragma once

#include <optional>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// Connected region. Its interior is to the left of all rings, and the first ring is the outer one.
/// If a cut connects a hole to another ring, both become one ring that follows the cut twice, once
/// in each direction. This cut is called the hole's bridge.
struct CutRegion {
  std::vector<Polygon> rings;

  /// Returns the number of points of all rings.
  size_t PointCount() const;
};

/// Index of a corner of a region: the ring's index, and the point's index in the ring.
struct CornerIndex {
  size_t ring = 0;
  size_t point = 0;

  friend bool operator==(const CornerIndex&, const CornerIndex&) = default;
};

/// Returns the point before point i of a closed ring.
inline Point Before(const Polygon& ring, size_t i) {
  return ring[i == 0 ? ring.size() - 1 : i - 1];
}
/// Returns the point after point i of a closed ring.
inline Point After(const Polygon& ring, size_t i) { return ring[i + 1 == ring.size() ? 0 : i + 1]; }

/// Returns the first reflex corner (more than 180 degrees), searched from `from` in the order of
/// rings. Returns nullopt if the region is convex and therefore has no holes. Exact.
std::optional<CornerIndex> FirstReflex(const CutRegion& region, CornerIndex from = {});

/// Cuts a region along the segment between two corners that see each other. Corners that become
/// straight are removed.
///
/// Shapes: two regions if both corners are on the same ring; one region if the cut joins two rings.
/// Cost: O(n), n points, plus O(n h) to assign h holes.
std::vector<CutRegion> CutAlong(CutRegion region, CornerIndex a, CornerIndex b);

}  // namespace slicefarm::exposure
