#pragma once

#include <span>
#include <vector>

#include "services/infill/algo/lines/clip_curves.h"

namespace slicefarm::infill {

/// The lines at `first_nm`, `first_nm` + `pitch_nm`, ... from an axis, up to `most_nm`, as closed
/// curves: around its ends they are round, and where two branches' lines meet they have a corner.
/// They split and merge where the axis has forks and rings.
///
/// Precision: 1/350 of the distance from the axis on curves. REQUIRES: first_nm > 0, pitch_nm > 0.
/// Cost: of an offset each (OffsetLines for the first, FastOffset for the others).
std::vector<Curve> AxisLevels(std::span<const Polyline> axis, double first_nm, double pitch_nm,
                              double most_nm);

}  // namespace slicefarm::infill
