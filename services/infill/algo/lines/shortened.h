#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Returns a line of length `length_nm` without its first `start_nm` and its last `end_nm`. If no
/// length would remain, returns the one point that divides the line in the ratio `start_nm` :
/// `end_nm`. New points are rounded to nm.
Polyline Shortened(const Polyline& line, double length_nm, double start_nm, double end_nm);

}  // namespace slicefarm::infill
