#pragma once

#include <cstdint>
#include <vector>

#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm::planning {

/// Where a region's sparse infill lies.
struct SkinRules {
  Coord walls_nm = 0;
  int32_t top_solid_layers = 0;
  int32_t bottom_solid_layers = 0;
  bool of_region_alone = false;  ///< skins also where another region lies above or below
};

/// Where sparse infill will lie in each layer, as the outlines alone tell: inside of the walls, and
/// deep enough below and above all that lies open. Beading and infill decide it to the last line;
/// what planning makes of this is cut to theirs.
/// Cost: O(n log n) for each pair of layers within reach of the skins that are not equal.
std::vector<MultiPolygon> SparseAreas(const ObjectStack& stack, const SkinRules& rules);

/// What of the sparse infill lies right below something else: solid infill that it has to carry.
/// `areas`: as SparseAreas gives them.
std::vector<MultiPolygon> RoofsOf(const std::vector<MultiPolygon>& areas);

/// Where nothing but walls and sparse infill is sure to carry what lies above: `areas`, and beside
/// them solid infill narrower than `least_nm`. On slopes that is a strip of each layer's, which
/// rests on the strip below or is none of the infill stage's.
/// `areas`: as SparseAreas gives them. Cost: O(n log n) for each layer that has both.
std::vector<MultiPolygon> HollowAreas(const ObjectStack& stack,
                                      const std::vector<MultiPolygon>& areas, Coord walls_nm,
                                      Coord least_nm);

}  // namespace slicefarm::planning
