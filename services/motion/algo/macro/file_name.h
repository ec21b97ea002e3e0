#pragma once

#include <string>
#include <string_view>

namespace slicefarm::motion {

/// A duration as names of files have it: "2d3h4m", "1h2m", "17m", "40s"; seconds are rounded into
/// minutes. Source: PrusaSlicer.
std::string ShortTime(double seconds);

/// The name of a file from output_filename_format, filled in. It names no folder: what cannot stand
/// in a name becomes `_`. Without an ending it gets ".gcode", or ".bgcode" if the file is binary;
/// the one becomes the other where the file is. Never empty, and 240 bytes at most.
std::string FileName(std::string_view filled_in, bool binary);

}  // namespace slicefarm::motion
