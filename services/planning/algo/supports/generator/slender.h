#pragma once

#include "services/planning/algo/supports/generator/raster.h"

namespace slicefarm::planning {

/// Returns the pixels around slender pieces of `bitmap`. A piece is a set of connected pixels; it
/// is slender if no disc of `radius_nm` fits into it. The result is a margin around each slender
/// piece, so wide that a disc would fit into both together. The pieces themselves are not in the
/// result. `stood`: columns at an earlier, higher check; pieces without a pixel in it are ignored.
/// REQUIRES: both bitmaps have the same grid, with a margin that no piece reaches. Cost: about 10
/// ns per pixel.
Bitmap AroundSlender(const Bitmap& bitmap, const Bitmap& stood, Coord radius_nm);

}  // namespace slicefarm::planning
