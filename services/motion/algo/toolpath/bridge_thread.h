#pragma once

#include "common/model/options/region_speeds.h"
#include "common/model/path.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Bridges in the air are round threads with the thickness that they have at the nozzle.

/// Returns the area of a disc, in mm2.
double DiscMm2(double diameter_mm);

/// Returns the diameter of threads from a region's settings, in mm.
double ThreadMm(const RegionSpeeds& region, double nozzle_mm);

/// Returns the diameter if the path is a thread according to its plastic; otherwise 0. The infill
/// stage prints threads as beads of their layer's height.
Coord ThreadNm(const Path& path, Coord bead_height_nm, const MotionOptions& options);

}  // namespace slicefarm::motion
