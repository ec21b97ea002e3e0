#pragma once

#include <span>
#include <vector>

#include "services/infill/algo/lines/clip_curves.h"

namespace slicefarm::infill {

/// Returns the lines at the distances `first_nm`, `first_nm` + `pitch_nm`, ... up to `most_nm` from
/// an axis, as closed curves around the axis. Each curve is round at the axis' ends and has a
/// corner where the lines of two branches meet. At forks and rings of the axis, lines split and
/// merge.
///
/// Precision: 1/350 of the distance from the axis on curves. REQUIRES: first_nm > 0, pitch_nm > 0.
/// Cost: one offset per line (OffsetLines for the first line, FastOffset for all further lines).
std::vector<Curve> AxisLevels(std::span<const Polyline> axis, double first_nm, double pitch_nm,
                              double most_nm);

}  // namespace slicefarm::infill
