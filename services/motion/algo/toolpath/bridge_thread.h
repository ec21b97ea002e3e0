#pragma once

#include "common/model/options/region_motion.h"
#include "common/model/path.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

// A bridge over air is printed as a round strand, which the code calls a thread. Its diameter
// follows from bridge_line_width, or the nozzle's diameter, and the bridge flow.

/// Returns the area of a disc, in mm2.
double DiscMm2(double diameter_mm);

/// Returns the diameter of a bridge's strand from a region's settings, in mm. `feature`: kind of
/// bridge.
double ThreadMm(const RegionMotion& region, double nozzle_mm,
                Feature feature = Feature::kBridgeInfill);

/// Returns the strand's diameter in nm if the path is a bridge with the cross-section of a round
/// strand; otherwise 0. The infill stage stores strands as beads of their layer's height with the
/// strand's section.
Coord ThreadNm(const Path& path, Coord bead_height_nm, const MotionOptions& options);

}  // namespace slicefarm::motion
