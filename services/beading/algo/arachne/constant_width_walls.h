#pragma once

#include <optional>

#include "common/geometry/polygon.h"
#include "services/beading/algo/arachne/variable_walls.h"
#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Returns the walls of an island that is everywhere wide enough for `max_walls` walls on each side
/// and infill between them. They are the walls that MakeVariableWalls would return, and have
/// constant widths: insets with arcs around reflex corners, because beads keep their distance from
/// the outline.
///
/// Returns nullopt for all other islands, and if an inset does not have one edge for each edge of
/// the outline (see TryOffset). REQUIRES: max_walls > 0 is the strategy's limit. Cost: O(n log n),
/// n points; a tenth of MakeVariableWalls.
std::optional<VariableWalls> TryWideWalls(const PolygonWithHoles& island,
                                          const BeadingStrategy& strategy, int max_walls,
                                          const VariableWallOptions& options);

/// Returns an inset ring in which each miter around a reflex corner of the original outline is
/// replaced by an arc. `distance_nm`: distance of the inset from the outline. Returns nullopt if an
/// arc does not fit between its neighbours. Exposed for tests.
std::optional<Polygon> RoundReflexCorners(const Polygon& ring, Coord distance_nm,
                                          Coord tolerance_nm);

}  // namespace slicefarm::beading
