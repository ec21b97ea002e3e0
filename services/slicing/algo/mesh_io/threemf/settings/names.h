#pragma once

#include <string>
#include <string_view>

namespace slicefarm::slicing::threemf {

/// Returns a name in a form that a report may show: UTF-8 without control characters and
/// surrounding blanks, cut to limits::kMaxNameBytes at the end of a character.
std::string CleanName(std::string_view text);

/// Returns a text from a project of OrcaSlicer in the format of a config.ini: UTF-8, with `\n` and
/// `\r` for line ends. Escapes that the text already contains do not change, because OrcaSlicer
/// evaluates them too: two vendors write their G-code on one line.
std::string EscapedText(std::string_view text);

}  // namespace slicefarm::slicing::threemf
