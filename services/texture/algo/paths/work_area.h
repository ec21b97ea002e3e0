#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "services/texture/algo/paths/boundary_margin.h"
#include "services/texture/algo/paths/tiled_section.h"

namespace slicefarm::texture {

/// Where a layer is worked, in the map: inside or outside of the texture's section, inside of
/// masks, and off the boundary.
struct WorkArea {
  TiledSection section;
  bool outside = false;
  std::vector<TiledSection> masks;
  const BoundaryMargin* margin = nullptr;  ///< null: up to the boundary

  bool Contains(const Eigen::Vector2d& map_mm) const;
  /// Adds the shares of a way at which that may change, in any order.
  void Cuts(const Eigen::Vector2d& a, const Eigen::Vector2d& b, std::vector<double>* shares) const;
  /// Whether all of a straight way lies in the area.
  bool ContainsAll(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;
};

}  // namespace slicefarm::texture
