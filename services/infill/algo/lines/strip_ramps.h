#pragma once

#include <vector>

#include "common/model/path.h"
#include "services/infill/algo/lines/fitted_strips.h"

namespace slicefarm::infill {

/// Returns the bead with its narrower parts widened, so that the strip's width never changes by
/// more than a fifth over a quarter of a pitch. Pressure in a nozzle cannot follow faster changes.
/// Where the width changes, points are at most a quarter of a pitch apart. The positions of both
/// ends do not change. Cost: O(points + length of ramps / pitch).
std::vector<StripPoint> EvenRamps(const std::vector<StripPoint>& bead, double pitch_nm);

/// Returns the path of a bead in a layer of height `height_nm`. It has a single width if the bead's
/// strip is constant.
Path PathOfStrip(const std::vector<StripPoint>& bead, Coord height_nm);

}  // namespace slicefarm::infill
