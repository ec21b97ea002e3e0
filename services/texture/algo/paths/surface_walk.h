#pragma once

#include <optional>
#include <vector>

#include "services/texture/algo/paths/surface_map.h"

namespace slicefarm::texture {

/// Path between two points over a surface.
struct SurfaceWalk {
  std::vector<SurfacePoint> between;  ///< points on edges and, along the boundary, at vertices
  bool straight = true;               ///< true if the path is straight in the map, without a detour
};

/// Returns the path between two points over the surface that is straight in the map. Where it
/// leaves the map, it follows the boundary to the next entry, in the shorter direction. Returns
/// nothing if rounding prevents it from reaching the target. Cost: O(triangles passed + boundary,
/// if it is met).
std::optional<SurfaceWalk> WalkBetween(const SurfaceMap& map, const SurfacePoint& from,
                                       const SurfacePoint& to);

}  // namespace slicefarm::texture
