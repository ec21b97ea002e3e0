#pragma once

#include <span>
#include <vector>

#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm::planning {

struct LightningRules {
  double radius_nm = 0;  ///< solid infill is carried at least this near to each of its places
  double beyond_nm = 0;  ///< how far lines reach into the walls
};

/// Lines that carry solid infill from below, and are as short as possible. From the top down: where
/// something has to be carried, branches grow from the walls, or from branches that are there,
/// first to the place that is farthest from both; from layer to layer they shrink into the walls,
/// at 45 degrees (lightning_trees.h). `areas` and `roofs`: as SparseAreas and RoofsOf give them, one a
/// layer.
///
/// Precision: places of solid infill are looked at on a grid of half the radius, or coarser where
/// that has more than kMaxRoofPoints.
/// Cost: O(places * branches) for each layer with roofs, O(branches * edges) for the others.
/// Source: the idea is that of T. Tricard, F. Claux, S. Lefebvre, "Ribbed support vaults for 3D
/// printing of hollowed objects", Computer Graphics Forum 39 (2020), made for lines in layers.
std::vector<std::vector<Polyline>> LightningLines(const ObjectStack& stack,
                                                  std::span<const MultiPolygon> areas,
                                                  std::span<const MultiPolygon> roofs,
                                                  const LightningRules& rules);
inline constexpr int kMaxRoofPoints = 50'000;

}  // namespace slicefarm::planning
