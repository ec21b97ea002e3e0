#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::gcode {

/// Keys and values, in the order of the file.
using Entries = std::vector<std::pair<std::string, std::string>>;

/// A picture in a file of G-code.
struct Picture {
  uint16_t format = 0;  ///< format of the picture; 0: PNG, 1: JPG, 2: QOI
  uint16_t width_px = 0;
  uint16_t height_px = 0;
  std::string data;
};

/// Parts of a file of G-code.
struct GcodeParts {
  std::string producer;     ///< program that made the file, such as "slicefarm 0.1.0"
  std::string produced_on;  ///< date of production
  std::string objects_info;
  std::vector<Picture> pictures;
  Entries facts;     ///< facts about the print: used filament, times, ...
  Entries settings;  ///< settings, sorted by key, as in the file
  std::string program;
};

/// Separates a file into its parts. Everything except metadata belongs to the program. Errors:
/// InvalidArgument for pictures that are not base64. Cost: O(bytes).
absl::StatusOr<GcodeParts> TakeApart(std::string_view gcode);

}  // namespace slicefarm::gcode
