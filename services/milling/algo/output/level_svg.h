#pragma once

#include <string>

#include "services/milling/algo/strategy/mill_steps.h"
#include "services/milling/algo/strategy/milling_job.h"

namespace slicefarm::milling {

/// A picture of a level in mm, y upwards: the stock's sides, where the tip may be, and its ways in
/// the order of cutting, from blue to red. Of a row, its runs as seen from above.
std::string LevelSvg(const MillingJob& job, const MilledStep& level);

}  // namespace slicefarm::milling
