#pragma once

#include <span>
#include <vector>

#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm::planning {

/// Distances for LightningLines.
struct LightningRules {
  double radius_nm = 0;  ///< each place of solid infill has support within this distance
  double beyond_nm = 0;  ///< length by which lines extend into the walls
};

/// Returns short lines that support solid infill from below. Works from the top down. Where solid
/// infill needs support, branches grow from the walls or from existing branches. The place that is
/// farthest from both gets the first branch. From layer to layer the branches shrink towards the
/// walls, at 45 degrees (lightning_trees.h). `areas` and `roofs`: one per layer, as from
/// SparseAreas and RoofsOf.
///
/// Precision: solid infill is sampled on a grid of half the radius. The grid is coarser if it would
/// have more than kMaxRoofPoints points.
/// Cost: O(places * branches) for each layer with roofs, O(branches * edges) for layers without.
/// Source: the idea is from T. Tricard, F. Claux, S. Lefebvre, "Ribbed support vaults for 3D
/// printing of hollowed objects", Computer Graphics Forum 39 (2020), adapted to lines in layers.
std::vector<std::vector<Polyline>> LightningLines(const ObjectStack& stack,
                                                  std::span<const MultiPolygon> areas,
                                                  std::span<const MultiPolygon> roofs,
                                                  const LightningRules& rules);
inline constexpr int kMaxRoofPoints = 50'000;

}  // namespace slicefarm::planning
