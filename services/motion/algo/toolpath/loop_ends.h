#pragma once

#include "common/model/path.h"

namespace slicefarm::motion {

/// Returns a point beside the start of a loop, at `distance_nm` along the bisector of its corner.
/// `left`: side of the loop's direction on which the point is. REQUIRES: `path` is closed.
Point BesideStart(const Path& path, Coord distance_nm, bool left);

}  // namespace slicefarm::motion
