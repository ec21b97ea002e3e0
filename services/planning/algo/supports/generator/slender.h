#pragma once

#include "services/planning/algo/supports/generator/raster.h"

namespace slicefarm::planning {

/// Returns the pixels around slender pieces of `bitmap`. A connected piece is slender if no disc of
/// `radius_nm` fits into it. The result is a margin around the piece, so wide that a disc fits.
/// Pieces without a common pixel with `stood` are ignored. The piece itself is not in the result.
/// REQUIRES: both bitmaps have the same grid, with a margin that no piece reaches. Cost: about 10
/// ns per pixel.
Bitmap AroundSlender(const Bitmap& bitmap, const Bitmap& stood, Coord radius_nm);

}  // namespace slicefarm::planning
