#pragma once

#include <string>

#include "services/exposure/algo/writers/writers.h"

namespace slicefarm::exposure {

/// G-code of lasers, for grbl 1.1 ($32=1) or Marlin 2 (inline power).
///
/// Absolute mm. Each layer's head moves to its height in Z; the layer switches the laser on with
/// power 0 (M4: power that follows the speed; M3: constant) and off at its end (M5). G-code of the
/// user's own stands before the words for units, around the move in Z and at the very end, always
/// with the laser off. Ways without exposure are
/// G0 with S0, so that no power is left on in a travel whatever the machine's mode; skywriting runs
/// are G1 with S0. S is power / full_power_w * full_power_s.
///
/// Focus: the head goes up by it, so Z is the layer's height and the style's focus_mm. Delays: G4
/// with the laser off, after jumps, at the ends of lines without skywriting and at their corners;
/// in seconds for grbl, in whole ms for Marlin, rounded up. The speed of jumps is F of Marlin's G0;
/// grbl knows but its own. There are no words for frequency and points: they stand in the header's
/// comments alone.
std::string LaserGcodeHeader(const FileFacts& facts);
std::string LaserGcodeLayerHead(const LayerFrame& layer, const LayerCode& code);
std::string LaserGcodeLayer(const ExposedLayer& layer, const FileFacts& facts);
std::string LaserGcodeFooter(const FileFacts& facts);

}  // namespace slicefarm::exposure
