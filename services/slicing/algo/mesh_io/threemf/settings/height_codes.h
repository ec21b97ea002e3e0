#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/options/height_code.h"

namespace slicefarm::slicing::threemf {

/// Codes at heights of the print. The key is the number of the plate, from 1. The beds of a
/// PrusaSlicer project count as plates.
using PlateHeightCodes = std::map<int64_t, std::vector<HeightCode>>;

/// Reads Metadata/Prusa_Slicer_custom_gcode_per_print_z.xml or Metadata/custom_gcode_per_layer.xml.
/// Both files contain the same codes, the first in lists per bed, the second in lists per plate.
/// Tool changes are left out. `part`: name of this file in the archive, for error messages. Errors:
/// any error of XmlParser; MESH_MALFORMED for heights and types that are not numbers;
/// MESH_TOO_LARGE above kMaxHeightCodes codes in the file.
absl::StatusOr<PlateHeightCodes> ReadHeightCodes(std::string_view text, const std::string& part);

}  // namespace slicefarm::slicing::threemf
