#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

#include "services/texture/algo/paths/surface_map.h"

namespace slicefarm::texture {

/// Options for placing a texture on a surface.
struct PlacementOptions {
  /// Point of the surface at which the texture's origin is placed; nullopt: the middle of the map.
  std::optional<Eigen::Vector3d> anchor_mm = {};
  std::optional<Eigen::Vector3d> direction =
      {};  ///< direction of the texture's x axis at the anchor; nullopt: the x axis of the map
  double turn_deg = 0;  ///< additional rotation of the texture, counter-clockwise
  double scale = 1;     ///< scale factor of the texture's width and length, not of its height
  bool repeat = true;   ///< true: the tile is repeated over the whole surface; false: one tile
  /// true: the middle of the tile is at the anchor; false: its lower left corner
  bool middle = false;
};

/// Conversion from the map to the texture's plane.
struct Placement {
  Eigen::Vector2d anchor_mm = Eigen::Vector2d::Zero();  ///< position of the anchor in the map
  /// point of the texture that is at the anchor
  Eigen::Vector2d origin_mm = Eigen::Vector2d::Zero();
  Eigen::Vector2d x_axis = Eigen::Vector2d(1, 0);  ///< direction of the texture's x axis in the map
  double scale = 1;
  bool repeat = true;

  /// Converts a position of the map to the texture's plane.
  Eigen::Vector2d ToTexture(const Eigen::Vector2d& map_mm) const {
    const Eigen::Vector2d way = map_mm - anchor_mm;
    return origin_mm +
           Eigen::Vector2d(x_axis.dot(way), x_axis.x() * way.y() - x_axis.y() * way.x()) / scale;
  }
};

/// Returns the placement on a map. The anchor is projected to the nearest point of the surface, the
/// direction to the tangent plane at this point. If the direction is perpendicular to the surface,
/// the map's x axis replaces it.
Placement PlacementOn(const SurfaceMap& map, const PlacementOptions& options,
                      const Eigen::Vector2d& tile_mm);

}  // namespace slicefarm::texture
