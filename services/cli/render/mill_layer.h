#pragma once

#include <optional>
#include <string_view>

#include "absl/status/statusor.h"
#include "services/cli/render/gcode_reader.h"

namespace slicefarm::cli {

/// Returns true if the program is a milling program of slicefarm: its first line names the tool.
bool IsMillProgram(std::string_view gcode);

/// Reads the toolpaths of a milling program. Levels are the heights at which the tip moves along x
/// or y at a feed rate, numbered from the top down. With a `level` the result has the toolpaths at
/// this height. Without a `level` it has all toolpaths as seen from above, including entries and
/// rest areas.
///
/// The feature of a toolpath is its phase ("roughing", "finishing", "rest areas"). Toolpaths are
/// drawn as thin as the picture allows. Rapid moves at the level are travels.
///
/// Supports G0 to G3 in X, Y, Z, I and J, absolute and in mm. Errors: REQUEST_MALFORMED if the
/// program cuts nothing, or, with the last level, if there is no level `level`. Cost: one pass over
/// the file.
absl::StatusOr<GcodeLayer> ReadMillLayer(std::string_view gcode, std::optional<int> level);

}  // namespace slicefarm::cli
