#pragma once

#include <string>

#include "services/exposure/algo/writers/writers.h"

namespace slicefarm::exposure {

/// Returns the header of a file in the Common Layer Interface 2.0; output.format decides between
/// ASCII and binary.
///
/// Choices that the format leaves open:
/// - Coordinates are in $$UNITS, to a thousandth of a unit in ASCII. In binary files they are
///   32-bit floats (long commands, little-endian, directly after $$HEADEREND, not aligned).
/// - $$DIMENSION is in mm. $$LAYER is the layer's upper side.
/// - Closed lines repeat their first point. They have direction 1 if they are counter-clockwise and
///   0 if clockwise, computed from the numbers in the file. Other lines, and lines without an area,
///   have direction 2.
/// - The id of a line is 5 * (rows of settings * object + settings) + kind + 1. So ids distinguish
///   parts, but not copies of the same part.
/// - Each id has a $$LABEL with its style, because CLI has no power or speed. The label contains
///   the part's name if there are several parts.
std::string CliHeader(const FileFacts& facts);
/// Returns the text or bytes of one layer.
std::string CliLayer(const ExposedLayer& layer, const FileFacts& facts);
/// Returns the end of the file.
std::string CliFooter(const FileFacts& facts);

}  // namespace slicefarm::exposure
