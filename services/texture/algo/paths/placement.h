#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

#include "services/texture/algo/paths/surface_map.h"

namespace slicefarm::texture {

/// How a texture lies on a surface.
struct PlacementOptions {
  std::optional<Eigen::Vector3d> anchor_mm = {};  ///< where its origin lies; none: the map's middle
  std::optional<Eigen::Vector3d> direction =
      {};               ///< along which its x runs there; none: the map's x
  double turn_deg = 0;  ///< further, counter-clockwise
  double scale = 1;     ///< of its width and length, not of its height
  bool repeat = true;   ///< over the whole surface; else one tile
  bool middle = false;  ///< its middle lies at the anchor, not its corner
};

/// From the map to the texture's plane and back.
struct Placement {
  Eigen::Vector2d anchor_mm = Eigen::Vector2d::Zero();  ///< in the map
  Eigen::Vector2d origin_mm = Eigen::Vector2d::Zero();  ///< in the texture, what lies there
  Eigen::Vector2d x_axis = Eigen::Vector2d(1, 0);       ///< the texture's x, in the map
  double scale = 1;
  bool repeat = true;

  Eigen::Vector2d ToTexture(const Eigen::Vector2d& map_mm) const {
    const Eigen::Vector2d way = map_mm - anchor_mm;
    return origin_mm +
           Eigen::Vector2d(x_axis.dot(way), x_axis.x() * way.y() - x_axis.y() * way.x()) / scale;
  }
};

/// An anchor is taken to the surface's point next to it, a direction into the surface there; one
/// that stands upright on it falls back to the map's x.
Placement PlacementOn(const SurfaceMap& map, const PlacementOptions& options,
                      const Eigen::Vector2d& tile_mm);

}  // namespace slicefarm::texture
