#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "services/cli/render/gcode_layer.h"

namespace slicefarm::cli {

/// Whether the file is one of the Common Layer Interface.
bool IsCliFile(std::string_view bytes);

/// Reads layer `index` of a CLI 2.0 file, ASCII or binary, in the order of scanning: each polyline
/// ("contour") and hatch line ("hatch") as a run of `width_mm`, for CLI tells no widths; kind, speed
/// and energy as the labels say them (line_style.h); comments are passed over; what lies between two runs is a travel. Source:
/// the format's description of 1994, hmilch.net. Errors: REQUEST_MALFORMED with the offset for what
/// is not as the format says, or naming the last layer. Cost: one pass over the file.
absl::StatusOr<GcodeLayer> ReadCliLayer(std::string_view bytes, int index, double width_mm);

}  // namespace slicefarm::cli
