#pragma once

#include <Eigen/Core>
#include <vector>

#include "common/model/scene/placement.h"
#include "services/texture/algo/paths/placement.h"
#include "services/texture/algo/pattern/section.h"

namespace slicefarm::texture {

/// Section of a texture over the map: repeated, rotated and scaled by its placement.
class TiledSection {
 public:
  /// Keeps a reference to `section`.
  TiledSection(const Section& section, const Eigen::Vector2d& tile_mm, const Placement& placement)
      : section_(&section), tile_mm_(tile_mm), placement_(placement) {}

  /// Returns true if a position of the map is solid.
  bool Contains(const Eigen::Vector2d& map_mm) const;

  /// Finds candidates for the points where the line from `a` to `b` enters or leaves the solid, and
  /// appends them to `shares`. Candidates are the line's crossings with outlines and with the sides
  /// of tiles. A candidate is a relative position on the line, from 0 to 1. The order is arbitrary.
  void Cuts(const Eigen::Vector2d& a, const Eigen::Vector2d& b, std::vector<double>* shares) const;

 private:
  bool IsThere(const Eigen::Vector2d& tile) const { return placement_.repeat || tile.isZero(0); }

  const Section* section_;
  Eigen::Vector2d tile_mm_;
  Placement placement_;
};

}  // namespace slicefarm::texture
