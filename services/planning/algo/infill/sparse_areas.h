#pragma once

#include <cstdint>
#include <vector>

#include "common/model/options/shell_extra.h"
#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm::planning {

/// Rules for the extent of a region's sparse infill.
struct SkinRules {
  int32_t top_solid_layers = 0;
  int32_t bottom_solid_layers = 0;
  ShellExtra top_spare = {}, bottom_spare = {};
  /// true: skins are also made where another region is above or below
  bool of_region_alone = false;
};

/// Returns each layer's region without the walls, which are `walls_nm` thick. Cost: O(n log n) for
/// n points of each layer that is not equal to the one below.
std::vector<MultiPolygon> InnerAreas(const ObjectStack& stack, Coord walls_nm);

/// Estimates the sparse infill of each layer from the outlines alone. The result is the part of
/// `inner` (see InnerAreas) that is deep enough below and above all open surfaces. Beading and
/// infill decide the exact areas later; the plan is cut to these exact areas. Cost: O(n log n) for
/// n points of each pair of different layers that are within the thickness of the skins.
std::vector<MultiPolygon> SparseAreas(const ObjectStack& stack, std::vector<MultiPolygon> inner,
                                      const SkinRules& rules);

/// Returns the sparse infill directly below solid infill, which it has to support. `areas`: as from
/// SparseAreas.
std::vector<MultiPolygon> RoofsOf(const std::vector<MultiPolygon>& areas);

/// Returns the areas where only walls and sparse infill are sure to support the layers above. These
/// are `areas`, and solid infill beside them that is narrower than `least_nm`. On slopes each layer
/// has such a strip. The strip lies on the strip below, or the infill stage does not print it at
/// all. `inner`, `areas`: as returned by InnerAreas and SparseAreas. Cost: O(n log n) for n points
/// of each layer that has both.
std::vector<MultiPolygon> HollowAreas(const std::vector<MultiPolygon>& inner,
                                      const std::vector<MultiPolygon>& areas, Coord least_nm);

}  // namespace slicefarm::planning
