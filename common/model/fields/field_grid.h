#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace slicefarm {

/// Position in mm: x and y in the object's own frame, z above the object's bottom.
using PositionMm = std::array<double, 3>;

/// Values at the nodes of a regular grid, with x as the fastest index. Values between nodes are
/// interpolated linearly. A position outside of the grid has the value of the nearest position
/// inside. INVARIANT: counts >= 1, spacings > 0, one value per node.
struct FieldGrid {
  std::array<int32_t, 3> count = {1, 1, 1};
  PositionMm origin_mm = {0, 0, 0};  ///< position of the first node
  PositionMm spacing_mm = {1, 1, 1};
  std::vector<double> values = {0};

  double At(const PositionMm& position_mm) const;

  friend bool operator==(const FieldGrid&, const FieldGrid&) = default;
};

/// Returns true if two grids have the same nodes.
bool SameNodes(const FieldGrid& a, const FieldGrid& b);

}  // namespace slicefarm
