#pragma once

#include <Eigen/Core>
#include <vector>

#include "common/model/scene/placement.h"
#include "services/texture/algo/paths/placement.h"
#include "services/texture/algo/pattern/section.h"

namespace slicefarm::texture {

/// Section of a texture over the map: repeated, turned and scaled by its placement.
class TiledSection {
 public:
  /// Keeps a reference to `section`.
  TiledSection(const Section& section, const Eigen::Vector2d& tile_mm, const Placement& placement)
      : section_(&section), tile_mm_(tile_mm), placement_(placement) {}

  /// Returns true if a position of the map is solid.
  bool Contains(const Eigen::Vector2d& map_mm) const;

  /// Appends to `shares` the relative positions on a line in the map where the line may enter or
  /// leave the solid, in any order: crossings with outlines and with the sides of tiles.
  void Cuts(const Eigen::Vector2d& a, const Eigen::Vector2d& b, std::vector<double>* shares) const;

 private:
  bool IsThere(const Eigen::Vector2d& tile) const { return placement_.repeat || tile.isZero(0); }

  const Section* section_;
  Eigen::Vector2d tile_mm_;
  Placement placement_;
};

}  // namespace slicefarm::texture
