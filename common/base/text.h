#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/strings/ascii.h"

namespace slicefarm {

/// A character that ends a line, moves the cursor or shows as nothing.
constexpr bool IsControl(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// An ASCII letter, a digit or an underscore.
inline bool IsOfName(char c) {
  return absl::ascii_isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// UTF-8 text with `with` for each character that some reader takes for the end of a line, or a
/// terminal for a command: control characters, also those beyond ASCII (U+0080 to U+009F), and
/// Unicode's line ends (U+2028, U+2029).
std::string ReplaceControls(std::string_view text, char with);

/// Without any of `blanks` at both sides.
std::string_view Trim(std::string_view text, std::string_view blanks = " \t\r\n\v\f");

/// The parts between any of `separators`: always one more than there are separators.
std::vector<std::string_view> Split(std::string_view text, std::string_view separators);

/// All of `text` as a decimal number, "-1.5e3". NaN, infinities and hexadecimals are none.
std::optional<double> ToNumber(std::string_view text);

}  // namespace slicefarm
