#pragma once

#include <string>
#include <string_view>

namespace slicefarm::slicing::threemf {

/// A name as a report may show it: UTF-8 without control characters, blanks around it taken off,
/// cut to limits::kMaxNameBytes at the border of a character.
std::string CleanName(std::string_view text);

/// A text of OrcaSlicer's as a config.ini has it: UTF-8, with `\n` and `\r` for line ends. What the
/// text has in such escapes is read as OrcaSlicer does: two vendors write their G-code on one line.
std::string EscapedText(std::string_view text);

}  // namespace slicefarm::slicing::threemf
