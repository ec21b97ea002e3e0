#pragma once

#include <string>
#include <string_view>

namespace slicefarm::slicing::threemf {

/// A name as a report may show it: UTF-8 without control characters, blanks around it taken off,
/// cut to limits::kMaxNameBytes at the border of a character.
std::string CleanName(std::string_view text);

/// A text as a config.ini has it: UTF-8, and `\n`, `\r` and `\\` for line ends and backslashes.
std::string EscapedText(std::string_view text);

}  // namespace slicefarm::slicing::threemf
