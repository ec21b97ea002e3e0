#pragma once

#include "services/motion/algo/toolpath/simplified_path.h"

namespace slicefarm::motion {

/// Returns a closed path without its last `gap_nm`, so that no blob is printed onto its beginning.
/// The flow does not change, so the gap's plastic is left out. A path no longer than four gaps
/// stays closed. Source: measured, PrusaSlicer 2.5 and 2.9: loops are clipped by seam_gap_distance
/// at their end.
SimplifiedPath WithOpenSeam(SimplifiedPath simple, Coord gap_nm);

}  // namespace slicefarm::motion
