#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// A line without its first `start_nm` and its last `end_nm`, of its length `length_nm`. Where no
/// length would be left: one point, which parts it in that proportion. New points are rounded.
Polyline Shortened(const Polyline& line, double length_nm, double start_nm, double end_nm);

}  // namespace slicefarm::infill
