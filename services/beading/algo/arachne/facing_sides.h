#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm::beading {

/// Looks for two sides of an island that face each other. Returns true if, seen straight across the
/// island from one of `looks` places at equal distances along the outline, the next edge is nearer
/// than `within_nm` and turns by more than `least_turn` radians (pi: it runs the opposite way).
/// False proves nothing. Cost: O(looks * n), n edges; about 3 ns per pair.
bool SeesFacingSides(const PolygonWithHoles& island, Coord within_nm, double least_turn, int looks);

}  // namespace slicefarm::beading
