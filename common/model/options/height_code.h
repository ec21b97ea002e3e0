#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/point.h"

namespace slicefarm {

/// Kind of G-code that is inserted at a height.
enum class HeightCodeKind : uint8_t {
  kColorChange,  ///< change of colour; `text`: the colour, #RRGGBB
  kPause,        ///< pause; `text`: message on the printer's display
  kTemplate,     ///< the setting template_custom_gcode
  kCustom,       ///< custom G-code; `text`: its lines, written unchanged
  /// Length of retractions from this height on, instead of retract_length. `text`: length in mm
  kRetractLength,
};

/// G-code that is inserted before a layer: the first layer with its top at or above the given
/// height.
struct HeightCode {
  Coord print_z_nm = 0;
  HeightCodeKind kind = HeightCodeKind::kCustom;
  std::string text;

  friend bool operator==(const HeightCode&, const HeightCode&) = default;
};

inline constexpr int kMaxHeightCodes = 10'000;
inline constexpr double kMaxRetractLengthMm = 1000;

/// Returns the length of a HeightCodeKind::kRetractLength, in mm. Nothing if its text is not a
/// number from 0 to kMaxRetractLengthMm.
std::optional<double> RetractLengthMm(const HeightCode& code);

/// Parses a list such as `[{"z":1.2,"type":"pause","text":"insert the nut"}]`. z: height in mm,
/// above 0. type: color_change, pause, template, custom or retract_length. text: optional, except
/// for retract_length. The result is sorted by height. An empty `text` gives an empty list. Errors:
/// InvalidArgument for any other text, and for more than kMaxHeightCodes codes.
absl::StatusOr<std::vector<HeightCode>> ParseHeightCodes(std::string_view text);

/// Returns the codes on one line in the form that ParseHeightCodes reads. Returns an empty text for
/// an empty list.
std::string PrintHeightCodes(const std::vector<HeightCode>& codes);

}  // namespace slicefarm
