#pragma once

#include <string>
#include <string_view>

namespace slicefarm {

/// `text` with each byte that belongs to no UTF-8 sequence replaced by '?', cut to at most
/// `max_bytes` at the border of a character. Messages quote what strangers sent; protobuf strings
/// and JSON must be UTF-8, and HTTP/2 trailers are small.
std::string ToUtf8(std::string_view text, size_t max_bytes);

bool IsUtf8(std::string_view text);

}  // namespace slicefarm
