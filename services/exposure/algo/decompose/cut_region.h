#pragma once

#include <optional>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// A connected region with its interior to the left of all rings: the first is the outer one. Where
/// a hole is bridged to another ring, the ring that both became passes the bridge twice.
struct CutRegion {
  std::vector<Polygon> rings;

  size_t PointCount() const;
};

/// A corner of a region.
struct CornerIndex {
  size_t ring = 0;
  size_t point = 0;

  friend bool operator==(const CornerIndex&, const CornerIndex&) = default;
};

inline Point Before(const Polygon& ring, size_t i) {
  return ring[i == 0 ? ring.size() - 1 : i - 1];
}
inline Point After(const Polygon& ring, size_t i) { return ring[i + 1 == ring.size() ? 0 : i + 1]; }

/// The first corner of more than 180 degrees, from `from` on in the order of rings; nullopt: the
/// region is convex, and then it has no holes. Exact.
std::optional<CornerIndex> FirstReflex(const CutRegion& region, CornerIndex from = {});

/// Cuts a region along the segment between two corners which see each other. Corners that become
/// straight are left out.
///
/// Shapes: two regions where both are corners of one ring; one where the cut joins two rings.
/// Cost:   O(n), and O(n h) where there are h holes to share out.
std::vector<CutRegion> CutAlong(CutRegion region, CornerIndex a, CornerIndex b);

}  // namespace slicefarm::exposure
