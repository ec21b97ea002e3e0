#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace slicefarm {

/// A character that ends a line, moves the cursor or shows as nothing.
constexpr bool IsControl(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// Without blanks, tabs and line ends at both sides.
std::string_view Trim(std::string_view text);

/// The parts between any of `separators`: always one more than there are separators.
std::vector<std::string_view> Split(std::string_view text, std::string_view separators);

/// All of `text` as a decimal number, "-1.5e3". NaN, infinities and hexadecimals are none.
std::optional<double> ToNumber(std::string_view text);

}  // namespace slicefarm
