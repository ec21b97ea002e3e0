#pragma once

#include <vector>

#include "common/model/path.h"
#include "services/infill/algo/lines/fitted_strips.h"

namespace slicefarm::infill {

/// The narrower parts of a bead made wider, so that its strip never changes by more than a fifth
/// over a quarter of a pitch: pressure in a nozzle follows no steps. Where it changes, points lie
/// no farther apart than that. Ends stay where they are. Cost: O(points + length of ramps / pitch).
std::vector<StripPoint> EvenRamps(const std::vector<StripPoint>& bead, double pitch_nm);

/// The path of a bead in a layer that is `height_nm` high; it has one width if the bead has.
Path PathOfStrip(const std::vector<StripPoint>& bead, Coord height_nm);

}  // namespace slicefarm::infill
