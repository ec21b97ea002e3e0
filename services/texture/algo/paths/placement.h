#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

#include "services/texture/algo/paths/surface_map.h"

namespace slicefarm::texture {

/// Options for placing a texture on a surface.
struct PlacementOptions {
  /// Position of the texture's origin on the surface; nullopt: the map's middle.
  std::optional<Eigen::Vector3d> anchor_mm = {};
  std::optional<Eigen::Vector3d> direction =
      {};  ///< direction of the texture's x axis at the anchor; nullopt: the x axis of the map
  double turn_deg = 0;  ///< additional rotation of the texture, counter-clockwise
  double scale = 1;     ///< scale factor of the texture's width and length, not of its height
  bool repeat = true;   ///< true: over the whole surface; false: one tile
  bool middle = false;  ///< true: the middle of the tile is at the anchor; false: its corner
};

/// Conversion from the map to the texture's plane.
struct Placement {
  Eigen::Vector2d anchor_mm = Eigen::Vector2d::Zero();  ///< position of the anchor in the map
  /// position in the texture that is at the anchor
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

/// Returns the placement on a map. An anchor is projected to the nearest point of the surface, and
/// a direction to the surface's tangent there. A direction perpendicular to the surface is replaced
/// by the map's x.
Placement PlacementOn(const SurfaceMap& map, const PlacementOptions& options,
                      const Eigen::Vector2d& tile_mm);

}  // namespace slicefarm::texture
