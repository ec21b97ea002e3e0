#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "services/infill/algo/lines/piece.h"

namespace slicefarm::infill {

/// Replaces the corners of lines inside a region by parabolas that begin and end `share` / 2 of the
/// shorter neighbouring edge from the corner, within 10 um. With a share of 1 the parabolas of two
/// corners meet in the middle of their edge. Corners that turn by more than 155 degrees or less
/// than 5 degrees stay, and so do corners
/// with parabolas that would cross the region's boundary. Ends of
/// lines do not move. Cost: O(n log m), n points of lines, m points of the region. REQUIRES: share
/// in (0, 1].
void RoundCorners(const MultiPolygon& region, double share, std::vector<Piece>& pieces);

}  // namespace slicefarm::infill
