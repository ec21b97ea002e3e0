#pragma once

#include <string>
#include <string_view>

namespace slicefarm::motion {

/// Returns `text` as one line for a comment, so that no part of it can become a command. A line
/// feed becomes the two characters \n, a carriage return \r, a backslash \\. Other control
/// characters (ReplaceControls) become spaces.
std::string OneLine(std::string_view text);

/// Returns an already escaped line for a comment: control characters become spaces.
std::string CommentLine(std::string_view line);

/// Returns `text` as a JSON string with its quotes. Bytes from 0x80 on are unchanged.
std::string JsonString(std::string_view text);

}  // namespace slicefarm::motion
