#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "services/texture/algo/paths/boundary_margin.h"
#include "services/texture/algo/paths/tiled_section.h"

namespace slicefarm::texture {

/// Area of the map where a layer is worked: inside or outside of the texture's section, inside of
/// masks, and away from the boundary.
struct WorkArea {
  TiledSection section;
  bool outside = false;
  std::vector<TiledSection> masks;
  const BoundaryMargin* margin = nullptr;  ///< null: the area extends to the boundary

  /// Returns true if a position is in the area.
  bool Contains(const Eigen::Vector2d& map_mm) const;
  /// Appends to `shares` the relative positions on the line from `a` to `b` where the line may
  /// enter or leave the area, in any order.
  void Cuts(const Eigen::Vector2d& a, const Eigen::Vector2d& b, std::vector<double>* shares) const;
  /// Returns true if a whole straight line is in the area.
  bool ContainsAll(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;
};

}  // namespace slicefarm::texture
