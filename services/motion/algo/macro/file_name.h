#pragma once

#include <string>
#include <string_view>

namespace slicefarm {
struct WritingOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Returns a duration in the form for file names: "2d3h4m", "1h2m", "17m", "40s". From one minute
/// on, the duration is rounded to whole minutes. Source: PrusaSlicer.
std::string ShortTime(double seconds);

/// Returns the name of a file from the filled-in output_filename_format. The name has no folder:
/// characters that a name cannot contain become `_`. A name without an ending gets the ending of
/// the file's format: ".gcode", ".bgcode" or ".gcode.3mf". A wrong one of the three is replaced.
/// The name is never empty and has at most 240 bytes.
std::string FileName(std::string_view filled_in, const WritingOptions& writing);

}  // namespace slicefarm::motion
