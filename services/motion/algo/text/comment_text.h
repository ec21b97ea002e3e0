#pragma once

#include <string>
#include <string_view>

namespace slicefarm::motion {

/// `text` as it may stand in a comment: on one line, so that nothing in it can become a command. A
/// line feed becomes "\n", a carriage return "\r", a backslash "\\"; other control characters
/// (ReplaceControls) become spaces.
std::string OneLine(std::string_view text);

/// A line that is escaped already, as it may stand in a comment: control characters become spaces.
std::string CommentLine(std::string_view line);

/// `text` as a JSON string with its quotes; bytes from 0x80 on stay as they are.
std::string JsonString(std::string_view text);

}  // namespace slicefarm::motion
