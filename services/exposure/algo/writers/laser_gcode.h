#pragma once

#include <string>

#include "services/exposure/algo/writers/writers.h"

namespace slicefarm::exposure {

/// G-code of lasers, for grbl 1.1 ($32=1) or Marlin 2 (inline power).
///
/// Absolute mm. Each layer starts with its height as Z and power 0, switches the laser on (M4:
/// power that follows the speed; M3: constant) and off at its end (M5). Ways without exposure are
/// G0 with S0, so that no power is left on in a travel whatever the machine's mode; skywriting runs
/// are G1 with S0. S is power / full_power_w * full_power_s. Delays are the scanner's, not the
/// file's; focus and frequency have no words and stand in the header's comments.
std::string LaserGcodeHeader(const FileFacts& facts);
std::string LaserGcodeLayer(const ExposedLayer& layer, const FileFacts& facts);
std::string LaserGcodeFooter(const FileFacts& facts);

}  // namespace slicefarm::exposure
