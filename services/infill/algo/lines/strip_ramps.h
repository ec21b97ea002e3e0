#pragma once

#include <vector>

#include "common/model/path.h"
#include "services/infill/algo/lines/fitted_strips.h"

namespace slicefarm::infill {

/// Widens the narrower parts of a bead, so that its strip never changes by more than a fifth over a
/// quarter of a pitch: pressure in a nozzle cannot follow steps. Where the strip changes, points
/// are at most a quarter of a pitch apart. Ends do not move. Cost: O(points + length of ramps /
/// pitch).
std::vector<StripPoint> EvenRamps(const std::vector<StripPoint>& bead, double pitch_nm);

/// Returns the path of a bead in a layer of height `height_nm`. It has a single width if the bead's
/// strip is constant.
Path PathOfStrip(const std::vector<StripPoint>& bead, Coord height_nm);

}  // namespace slicefarm::infill
