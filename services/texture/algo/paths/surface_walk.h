#pragma once

#include <optional>
#include <vector>

#include "services/texture/algo/paths/surface_map.h"

namespace slicefarm::texture {

struct SurfaceWalk {
  std::vector<SurfacePoint> between;  ///< on edges and, along the boundary, at vertices
  bool straight = true;               ///< in the map: it did not have to go around anything
};

/// The way between two points over the surface that is straight in the map; where that leaves the
/// map, it goes along the boundary to where it comes back, the shorter way round. None: rounding
/// keeps it from finding back. Cost: O(triangles passed + boundary, if it is met).
std::optional<SurfaceWalk> WalkBetween(const SurfaceMap& map, const SurfacePoint& from,
                                       const SurfacePoint& to);

}  // namespace slicefarm::texture
