#pragma once

#include "common/geometry/polygon.h"
#include "common/model/options/surface_options.h"

namespace slicefarm::infill {

/// Parameters of TopGrowth.
struct GrowthRules {
  const SurfaceOptions& surfaces;
  Coord walls_nm = 0;        ///< total width of the walls
  Coord width_nm = 400'000;  ///< width of the lines of top surfaces
};

/// Returns the area by which the top surfaces of a layer grow, and which the layer above covers:
/// the area within the distance of the settings, inside the walls and their margin, on the same
/// island. Surfaces narrower than two lines do not grow. `outline`, `above`: outlines of the layer
/// and of the layer above. Cost: a few boolean operations and offsets per island with a top
/// surface.
MultiPolygon TopGrowth(const MultiPolygon& outline, const MultiPolygon& above,
                       const GrowthRules& rules);

}  // namespace slicefarm::infill
