#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Returns `islands`, with islands that are on average narrower than `width_nm` widened to about
/// this width. Cost: an offset for each narrow island.
MultiPolygon Widened(const MultiPolygon& islands, Coord width_nm);

}  // namespace slicefarm::planning
