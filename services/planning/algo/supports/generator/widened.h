#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Returns the islands that are on average narrower than `width_nm`, widened to about this width.
/// All other islands are not in the result. Cost: an offset for each narrow island.
MultiPolygon Widened(const MultiPolygon& islands, Coord width_nm);

}  // namespace slicefarm::planning
