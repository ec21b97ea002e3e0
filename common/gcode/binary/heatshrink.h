#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm::gcode {

/// The bytes as Heatshrink has them, with a window of 2^12 bytes and matches of up to 2^4: of all
/// such streams, a shortest one. At most 9/8 of the bytes, and one more.
/// Cost: O(bytes) on G-code; O(4096 bytes) of what repeats without end at worst.
/// Source: the format of heatshrink 0.4: from the highest bit on, 1 and a byte, or 0, how far back
/// less one in 12 bits, and how many bytes less one in 4.
std::string Heatshrink(std::string_view bytes);

/// Returns the `size` bytes of a stream with a window of 2^`window_bits` bytes and matches of up to
/// 2^4. Errors: InvalidArgument for a stream that ends too early or looks back beyond its beginning.
absl::StatusOr<std::string> Unheatshrink(std::string_view stream, size_t size, int window_bits);

}  // namespace slicefarm::gcode
