#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// The islands that are on average narrower than `width_nm`, made about as wide. Cost: an offset
/// for each.
MultiPolygon Widened(const MultiPolygon& islands, Coord width_nm);

}  // namespace slicefarm::planning
