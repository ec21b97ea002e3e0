#pragma once

#include <string>

#include "services/milling/algo/strategy/mill_steps.h"
#include "services/milling/algo/strategy/milling_job.h"

namespace slicefarm::milling {

/// Returns a picture of a level in mm, with y upwards. It shows the stock's sides, the area in
/// which the tip can move, and the passes in the order of cutting, from blue to red. If the step is
/// a row of rest areas, the picture shows its runs from above.
std::string LevelSvg(const MillingJob& job, const MilledStep& level);

}  // namespace slicefarm::milling
