#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "services/cli/render/gcode_reader.h"

namespace slicefarm::cli {

/// Returns true if the file is in the Common Layer Interface format.
bool IsCliFile(std::string_view bytes);

/// Reads layer `index` of a CLI 2.0 file, ASCII or binary. The result's BeadRuns are in the order
/// of scanning. Each polyline ("contour") and hatch line ("hatch") becomes a BeadRun with the width
/// `width_mm`, because CLI has no widths. Kind, speed and energy are from the labels
/// (line_style.h). Comments are skipped. There is a travel between two BeadRuns.
///
/// Source: the format's description of 1994, hmilch.net. Errors: REQUEST_MALFORMED with the offset
/// of a violation of the format, or with the last layer if there is no layer `index`. Cost: one
/// pass over the file.
absl::StatusOr<GcodeLayer> ReadCliLayer(std::string_view bytes, int index, double width_mm);

}  // namespace slicefarm::cli
