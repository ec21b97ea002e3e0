#pragma once

#include <cstdint>
#include <vector>

#include "common/model/options/skin_spare.h"
#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm::planning {

/// Where a region's sparse infill lies.
struct SkinRules {
  int32_t top_solid_layers = 0;
  int32_t bottom_solid_layers = 0;
  SkinSpare top_spare = {}, bottom_spare = {};
  bool of_region_alone = false;  ///< skins also where another region lies above or below
};

/// What walls of that thickness leave of each layer's region.
/// Cost: O(n log n) for each layer that is not equal to the one below.
std::vector<MultiPolygon> InnerAreas(const ObjectStack& stack, Coord walls_nm);

/// Where sparse infill will lie in each layer, as the outlines alone tell: of `inner`, as
/// InnerAreas gives it, what is deep enough below and above all that lies open. Beading and infill
/// decide it to the last line; what planning makes of this is cut to theirs.
/// Cost: O(n log n) for each pair of layers within reach of the skins that are not equal.
std::vector<MultiPolygon> SparseAreas(const ObjectStack& stack, std::vector<MultiPolygon> inner,
                                      const SkinRules& rules);

/// What of the sparse infill lies right below something else: solid infill that it has to carry.
/// `areas`: as SparseAreas gives them.
std::vector<MultiPolygon> RoofsOf(const std::vector<MultiPolygon>& areas);

/// Where nothing but walls and sparse infill is sure to carry what lies above: `areas`, and beside
/// them solid infill narrower than `least_nm`. On slopes that is a strip of each layer's, which
/// rests on the strip below or is none of the infill stage's.
/// `inner`, `areas`: as InnerAreas and SparseAreas give them. Cost: O(n log n) for each layer that
/// has both.
std::vector<MultiPolygon> HollowAreas(const std::vector<MultiPolygon>& inner,
                                      const std::vector<MultiPolygon>& areas, Coord least_nm);

}  // namespace slicefarm::planning
