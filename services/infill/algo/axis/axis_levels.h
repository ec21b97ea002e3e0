#pragma once

#include <span>
#include <vector>

#include "services/infill/algo/lines/clip_curves.h"

namespace slicefarm::infill {

/// Returns the lines at the distances `first_nm`, `first_nm` + `pitch_nm`, ... from an axis, up to
/// `most_nm`, as closed curves. They are round at the axis' ends, have a corner where the lines of
/// two branches meet, and split and merge at the axis' forks and rings.
///
/// Precision: 1/350 of the distance from the axis on curves. REQUIRES: first_nm > 0, pitch_nm > 0.
/// Cost: one offset per line (OffsetLines for the first line, FastOffset for all further lines).
std::vector<Curve> AxisLevels(std::span<const Polyline> axis, double first_nm, double pitch_nm,
                              double most_nm);

}  // namespace slicefarm::infill
