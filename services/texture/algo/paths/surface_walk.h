#pragma once

#include <optional>
#include <vector>

#include "services/texture/algo/paths/surface_map.h"

namespace slicefarm::texture {

/// Path between two points over a surface.
struct SurfaceWalk {
  /// points between start and end, without them: on edges and, along the boundary, at vertices
  std::vector<SurfacePoint> between;
  bool straight = true;  ///< true if the path is straight in the map, without a detour
};

/// Returns the path over the surface between two points that is straight in the map. Where the
/// straight line leaves the map, the path follows the boundary to the point where the line enters
/// the map again, in the shorter direction. Returns nullopt if the path does not reach the target
/// because of rounding. Cost: O(triangles passed), plus O(boundary) if the line meets the boundary.
std::optional<SurfaceWalk> WalkBetween(const SurfaceMap& map, const SurfacePoint& from,
                                       const SurfacePoint& to);

}  // namespace slicefarm::texture
