#pragma once

#include <optional>

#include "common/geometry/polygon.h"
#include "services/beading/algo/arachne/variable_walls.h"
#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Returns the walls of an island that is everywhere wide enough for `max_walls` walls on each side
/// and infill between them. MakeVariableWalls would return the same walls. Each wall has a constant
/// width. Walls are insets of the outline with arcs around reflex corners, where a plain inset
/// would have miters.
///
/// Returns nullopt for all other islands, for islands with a small fill (see SmallFills), and if an
/// inset's curve is not in general position. REQUIRES: max_walls > 0 is the strategy's limit. Cost:
/// O(n log n), n points; a tenth of MakeVariableWalls if each edge of the outline has an edge in
/// each inset, a quarter otherwise.
std::optional<VariableWalls> TryWideWalls(const PolygonWithHoles& island,
                                          const BeadingStrategy& strategy, int max_walls,
                                          const VariableWallOptions& options);

/// Replaces the miter at each reflex corner of an inset ring by an arc and returns the new ring.
/// `distance_nm`: distance of the inset from the outline, the radius of the arcs. `tolerance_nm`:
/// chord tolerance of the arcs. Returns nullopt if an edge is too short for the arcs at its ends,
/// or if a corner is so sharp that the inset has a square cut there. Exposed for tests.
std::optional<Polygon> RoundReflexCorners(const Polygon& ring, Coord distance_nm,
                                          Coord tolerance_nm);

}  // namespace slicefarm::beading
