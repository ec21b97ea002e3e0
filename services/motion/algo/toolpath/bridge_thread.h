#pragma once

#include "common/model/options/region_motion.h"
#include "common/model/path.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Bridges in the air are round strands (called threads here). Their diameter is the diameter that
/// they have at the nozzle.

/// Returns the area of a disc, in mm2.
double DiscMm2(double diameter_mm);

/// Returns the diameter of a bridge's strand from a region's settings, in mm. `feature`: kind of
/// bridge.
double ThreadMm(const RegionMotion& region, double nozzle_mm,
                Feature feature = Feature::kBridgeInfill);

/// Returns the diameter if the path has the plastic of a round strand; otherwise 0. The infill
/// stage stores strands as beads of their layer's height.
Coord ThreadNm(const Path& path, Coord bead_height_nm, const MotionOptions& options);

}  // namespace slicefarm::motion
