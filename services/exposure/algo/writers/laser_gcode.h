#pragma once

#include <string>

#include "services/exposure/algo/writers/writers.h"

namespace slicefarm::exposure {

/// Returns the header of G-code for lasers: grbl 1.1 ($32=1) or Marlin 2 (inline power).
///
/// Coordinates are absolute, in mm. The head of each layer moves to the layer's height in Z. Each
/// layer turns the laser on with power 0 at its start (M4: power in proportion to the speed; M3:
/// constant power), and off at its end (M5). The user's own G-code is before the commands for
/// units, before and after the move in Z, and at the very end, always with the laser off. Moves
/// without exposure are G0 with S0, so that no power remains on in a travel in any mode of the
/// machine. Skywriting moves are G1 with S0. S is power / full_power_w * full_power_s.
///
/// Focus: Z is the layer's height plus the style's focus_mm. Delays are G4 with the laser off:
/// after jumps, at the ends of lines without skywriting, and at the corners of these lines. Delays
/// are in seconds for grbl, and in whole ms for Marlin, rounded up. The speed of jumps is F of
/// Marlin's G0; grbl uses only its own speed. Frequency and points have no G-code words: they are
/// only in the header's comments.
std::string LaserGcodeHeader(const FileFacts& facts);
/// Returns the move to a layer's height, with the user's G-code around it.
std::string LaserGcodeLayerHead(const LayerFrame& layer, const LayerCode& code);
/// Returns the moves of one layer.
std::string LaserGcodeLayer(const ExposedLayer& layer, const FileFacts& facts);
/// Returns the end of the file.
std::string LaserGcodeFooter(const FileFacts& facts);

}  // namespace slicefarm::exposure
