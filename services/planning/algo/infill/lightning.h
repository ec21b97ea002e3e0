#pragma once

#include <span>
#include <vector>

#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm::planning {

/// Distances for LightningLines.
struct LightningRules {
  /// largest distance from a point of solid infill to a line that supports it
  double radius_nm = 0;
  double beyond_nm = 0;  ///< length by which lines extend beyond the infill's area, into the walls
  // Tangents of angles from the vertical:
  double overhang = 1;    ///< overhang of solid infill that walls hold without lines
  double prune = 1;       ///< steepest tips of branches
  double straighten = 1;  ///< steepest move of the other nodes
};

/// Returns the lines of each layer, indexed like `stack`, that support solid infill from below.
/// Works from the top down. Where solid infill needs support, branches grow from the walls or from
/// existing branches. The first branch grows to the point that is farthest from walls and branches,
/// then the next one, until no point is farther than the radius. From layer to layer downwards, the
/// branches shrink towards the walls, at the angles of the rules (lightning_trees.h). Walls hold
/// solid infill within the radius at an overhang of 45 degrees; other overhangs change this length
/// by as much as they change the step from layer to layer. `areas` and `roofs`: one
/// per layer, as returned by HollowAreas and RoofsOf.
///
/// Precision: solid infill is sampled on a grid of half the radius. The grid is coarser if it would
/// have more than kMaxRoofPoints points. Cost: O(sample points * branches) for each layer with
/// roofs, O(branches * edges) for layers without. Source: the idea is from T. Tricard, F. Claux, S.
/// Lefebvre, "Ribbed support vaults for 3D printing of hollowed objects", Computer Graphics Forum
/// 39 (2020), adapted to lines in layers.
std::vector<std::vector<Polyline>> LightningLines(const ObjectStack& stack,
                                                  std::span<const MultiPolygon> areas,
                                                  std::span<const MultiPolygon> roofs,
                                                  const LightningRules& rules);
inline constexpr int kMaxRoofPoints = 50'000;

}  // namespace slicefarm::planning
