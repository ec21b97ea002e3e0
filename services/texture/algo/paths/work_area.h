#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "services/texture/algo/paths/boundary_margin.h"
#include "services/texture/algo/paths/tiled_section.h"

namespace slicefarm::texture {

/// Area of the map where a layer is worked: inside (or, by option, outside) of the texture's
/// section, inside of the mask, and away from the boundary.
struct WorkArea {
  TiledSection section;
  bool outside = false;
  std::vector<TiledSection> masks;
  const BoundaryMargin* margin = nullptr;  ///< null: the area extends to the boundary

  /// Returns true if a position is in the area.
  bool Contains(const Eigen::Vector2d& map_mm) const;
  /// Finds candidates for the points where the line from `a` to `b` enters or leaves the area, and
  /// appends them to `shares`. A candidate is a relative position on the line, from 0 to 1. The
  /// order is arbitrary.
  void Cuts(const Eigen::Vector2d& a, const Eigen::Vector2d& b, std::vector<double>* shares) const;
  /// Returns true if a whole straight line is in the area.
  bool ContainsAll(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;
};

}  // namespace slicefarm::texture
