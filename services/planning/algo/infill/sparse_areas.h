#pragma once

#include <cstdint>
#include <vector>

#include "common/model/options/shell_extra.h"
#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm::planning {

/// Settings that decide the extent of a region's sparse infill.
struct SkinRules {
  int32_t top_solid_layers = 0;
  int32_t bottom_solid_layers = 0;
  ShellExtra top_spare = {}, bottom_spare = {};
  /// true if skins are also made where another region is above or below
  bool of_region_alone = false;
};

/// Returns, for each layer, the region without its walls, which are `walls_nm` thick. Cost: O(n log
/// n) for n points of each layer that is not equal to the one below.
std::vector<MultiPolygon> InnerAreas(const ObjectStack& stack, Coord walls_nm);

/// Estimates the sparse infill of each layer from the outlines alone. `inner`: the result of
/// InnerAreas. The result is the part of `inner` that is covered by enough layers above and below
/// to need no skin. The beading and infill stages decide the exact areas later, and cut the plan to
/// them. Cost: O(n log n) for n points of each pair of different layers that are within the
/// thickness of the skins.
std::vector<MultiPolygon> SparseAreas(const ObjectStack& stack, std::vector<MultiPolygon> inner,
                                      const SkinRules& rules);

/// Returns, for each layer, the part of its sparse infill that is directly below solid infill and
/// has to support it. `areas`: the result of SparseAreas or HollowAreas.
std::vector<MultiPolygon> RoofsOf(const std::vector<MultiPolygon>& areas);

/// Returns, for each layer, the area where only walls and sparse infill are sure to support the
/// layers above. This is the area in `areas`, and solid infill in `inner` that is narrower than
/// `least_nm`. On slopes each layer has a narrow strip of solid infill; the infill stage may not
/// print it, or prints it on the strip below. `inner`, `areas`: as returned by InnerAreas and
/// SparseAreas. Cost: O(n log n) for n points of each layer that has both.
std::vector<MultiPolygon> HollowAreas(const std::vector<MultiPolygon>& inner,
                                      const std::vector<MultiPolygon>& areas, Coord least_nm);

}  // namespace slicefarm::planning
