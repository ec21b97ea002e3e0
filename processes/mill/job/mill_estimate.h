#pragma once

#include "processes/mill/model/milling_options.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// Estimates the milling time from areas and perimeters of layers alone:
/// - roughing: removed volume, divided by stepover times stepdown;
/// - waterlines: from the perimeters;
/// - rest areas: from the area of each layer that no layer above covers.
///
/// Entries, rapid moves and the passes around the stock are left out. If the stock is an object, it
/// is treated as a part, because the layers do not distinguish the two. Cost: O(points).
JobEstimate EstimateMilling(const SlicedOutlines& job, const MillingOptions& how);

}  // namespace slicefarm::coordinator
