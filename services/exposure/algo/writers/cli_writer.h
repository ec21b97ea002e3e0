#pragma once

#include <string>

#include "services/exposure/algo/writers/writers.h"

namespace slicefarm::exposure {

/// Common Layer Interface 2.0, by output.format ASCII or binary.
///
/// Choices where the format leaves some: coordinates are in $$UNITS, to a thousandth of one (ASCII)
/// or as 32-bit floats (binary, long commands, little-endian, right behind $$HEADEREND, not
/// aligned); $$DIMENSION is in mm; $$LAYER is the layer's upper side; closed lines repeat their
/// first point and have direction 1 if they run counter-clockwise, 0 if clockwise, as the numbers
/// in the file have it; other lines, and those without an area, have 2. The id of a line is 5 *
/// (rows of settings * object + settings) + kind + 1, so parts can be told apart, but for copies of
/// one; each has a $$LABEL that says its style, as CLI has no power or speed, and the part's name
/// if there are several.
std::string CliHeader(const FileFacts& facts);
std::string CliLayer(const ExposedLayer& layer, const FileFacts& facts);
std::string CliFooter(const FileFacts& facts);

}  // namespace slicefarm::exposure
