#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm::beading {

/// Returns true if two sides of an island are found that face each other. The function looks
/// straight across the island from `looks` places at equal distances along the outline. The next
/// edge must be nearer than `within_nm` and turn by more than `least_turn` radians; two parallel
/// sides turn by pi. False proves nothing. Cost: O(looks * n), n edges; about 3 ns per pair.
bool SeesFacingSides(const PolygonWithHoles& island, Coord within_nm, double least_turn, int looks);

}  // namespace slicefarm::beading
