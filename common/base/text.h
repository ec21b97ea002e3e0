#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/strings/ascii.h"

namespace slicefarm {

/// Returns true for an ASCII control character, which could end a line, move a terminal's cursor or
/// be invisible.
constexpr bool IsControl(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// Returns true if the character may be part of a name: an ASCII letter, a digit or an underscore.
inline bool IsOfName(char c) {
  return absl::ascii_isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// Returns the UTF-8 text with `with` in place of characters that a reader may take for a line end,
/// or a terminal for a command. These are control characters, also beyond ASCII (U+0080 to U+009F),
/// and the line ends of Unicode (U+2028, U+2029).
std::string ReplaceControls(std::string_view text, char with);

/// Returns the text without the characters of `blanks` at both ends.
std::string_view Trim(std::string_view text, std::string_view blanks = " \t\r\n\v\f");

/// Splits a text at each character that is one of `separators`. If the text has n separators, the
/// result has n + 1 parts, some of which may be empty.
std::vector<std::string_view> Split(std::string_view text, std::string_view separators);

/// Returns the value of a text that consists of one decimal number, such as "-1.5e3". Returns
/// nullopt for NaN, infinities, hexadecimal numbers and other texts.
std::optional<double> ToNumber(std::string_view text);

}  // namespace slicefarm
