#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace slicefarm {

using PlaceMm = std::array<double, 3>;  ///< x, y of the object's own frame; z above its bottom

/// Values at the nodes of a box, x running fastest: linear between nodes, and beyond the box as at
/// its nearest place. INVARIANT: counts >= 1, spacings > 0, a value for each node.
struct FieldGrid {
  std::array<int32_t, 3> count = {1, 1, 1};
  PlaceMm origin_mm = {0, 0, 0};  ///< of the first node
  PlaceMm spacing_mm = {1, 1, 1};
  std::vector<double> values = {0};

  double At(const PlaceMm& place_mm) const;

  friend bool operator==(const FieldGrid&, const FieldGrid&) = default;
};

/// Whether two grids have the same nodes.
bool SameNodes(const FieldGrid& a, const FieldGrid& b);

}  // namespace slicefarm
