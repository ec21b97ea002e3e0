#pragma once

#include <optional>

#include "common/geometry/polygon.h"
#include "services/beading/algo/strategy/beading_strategy.h"
#include "services/beading/algo/arachne/variable_walls.h"

namespace slicefarm::beading {

/// What MakeVariableWalls makes of an island that is nowhere too thin for `max_walls` walls on
/// either side and something between them: walls of constant width. They are insets, with arcs
/// around reflex corners, as beads keep their distance from the outline.
///
/// nullopt for all other islands, and where an inset is not one edge by edge (see TryOffset).
/// REQUIRES: max_walls > 0, the strategy's limit. Cost: O(n log n); a tenth of MakeVariableWalls.
std::optional<VariableWalls> TryWideWalls(const PolygonWithHoles& island,
                                          const BeadingStrategy& strategy, int max_walls,
                                          const VariableWallOptions& options);

/// An inset ring with each miter around a reflex corner of what it was inset from made an arc.
/// nullopt where an arc does not fit beside its neighbours. Exposed for tests.
std::optional<Polygon> RoundReflexCorners(const Polygon& ring, Coord distance_nm,
                                          Coord tolerance_nm);

}  // namespace slicefarm::beading
