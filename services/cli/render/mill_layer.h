#pragma once

#include <optional>
#include <string_view>

#include "absl/status/statusor.h"
#include "services/cli/render/gcode_layer.h"

namespace slicefarm::cli {

/// Whether a text is a milling program as slicefarm writes it: its first line names the tool.
bool IsMillProgram(std::string_view gcode);

/// Reads the ways of a milling program. `level`: by the heights, from the top down, at which the
/// tip goes along x or y at a feed, with its ways there; none: all ways, as seen from above,
/// entries and rest areas too. Ways are named for their phase ("roughing", "finishing", "rest
/// areas"), as thin as the picture allows; rapid moves at the level are travels.
///
/// Follows G0 to G3 in X, Y, Z, I and J, absolute and in mm. Errors: REQUEST_MALFORMED if nothing
/// is cut, or naming the last level. Cost: one pass over the file.
absl::StatusOr<GcodeLayer> ReadMillLayer(std::string_view gcode, std::optional<int> level);

}  // namespace slicefarm::cli
