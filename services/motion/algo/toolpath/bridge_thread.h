#pragma once

#include "common/model/options/region_speeds.h"
#include "common/model/path.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Bridges in the air are round threads, as thick as they leave the nozzle.

double DiscMm2(double diameter_mm);

/// Diameter of threads by a region's settings.
double ThreadMm(const RegionSpeeds& region, double nozzle_mm);

/// Returns the diameter if a path is such a thread, by its plastic; else 0. Infill lays threads as
/// beads of their layer's height.
Coord ThreadNm(const Path& path, Coord bead_height_nm, const MotionOptions& options);

}  // namespace slicefarm::motion
