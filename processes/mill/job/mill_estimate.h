#pragma once

#include "processes/mill/model/milling_options.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// What milling will take, from areas and perimeters of layers alone: roughing by the volume that
/// goes over stepover times stepdown, waterlines by perimeter, rest areas by what of a layer
/// nothing lies above. Entries, rapid moves and the way around the stock are left out; a stock that
/// is an object counts as a part, as layers do not tell them apart. Cost: O(points).
JobEstimate EstimateMilling(const SlicedOutlines& job, const MillingOptions& how);

}  // namespace slicefarm::coordinator
