#pragma once

#include <string>
#include <string_view>

namespace slicefarm {

/// Returns `text` as valid UTF-8 of at most `max_bytes`, never cut within a character. Each byte
/// that belongs to no UTF-8 sequence becomes '?'. Needed because messages contain untrusted input,
/// protobuf strings and JSON must be UTF-8, and HTTP/2 trailers are small.
std::string ToUtf8(std::string_view text, size_t max_bytes);

/// Returns true if the whole text is valid UTF-8.
bool IsUtf8(std::string_view text);

}  // namespace slicefarm
