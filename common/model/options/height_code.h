#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/point.h"

namespace slicefarm {

enum class HeightCodeKind : uint8_t {
  kColorChange,  ///< `text`: the colour, #RRGGBB
  kPause,        ///< `text`: what the printer shows meanwhile
  kTemplate,     ///< template_custom_gcode
  kCustom,       ///< `text`: lines of G-code, as they are
};

/// G-code before the layer whose top is the first at or above a height of the print.
struct HeightCode {
  Coord print_z_nm = 0;
  HeightCodeKind kind = HeightCodeKind::kCustom;
  std::string text;

  friend bool operator==(const HeightCode&, const HeightCode&) = default;
};

inline constexpr int kMaxHeightCodes = 10'000;

/// `[{"z":1.2,"type":"pause","text":"insert the nut"}]`: z in mm above 0; type: color_change,
/// pause, template or custom; text: may be left out. They come back by height. Empty: none. Errors:
/// InvalidArgument for anything else, and for more than kMaxHeightCodes.
absl::StatusOr<std::vector<HeightCode>> ParseHeightCodes(std::string_view text);

/// As ParseHeightCodes reads it, on one line; empty for none.
std::string PrintHeightCodes(const std::vector<HeightCode>& codes);

}  // namespace slicefarm
