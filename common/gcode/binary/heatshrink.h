#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm::gcode {

/// Compresses bytes in the format of Heatshrink, with a window of 2^12 bytes and matches of up to
/// 2^4 bytes. No other stream in this format is shorter. The size is at most 9/8 of the bytes, plus
/// one. Cost: O(n) for n bytes of G-code; at worst, for endless repetitions, O(4096 n).
///
/// Source: the format of heatshrink 0.4, from the highest bit on. A literal is a 1 and a byte. A
/// match is a 0, its distance minus one in 12 bits, and its length minus one in 4 bits.
std::string Heatshrink(std::string_view bytes);

/// Decompresses a stream made with a window of 2^`window_bits` bytes and matches of up to 2^4
/// bytes. Returns `size` bytes. Errors: InvalidArgument for a stream that ends too early or refers
/// to bytes before its beginning.
absl::StatusOr<std::string> Unheatshrink(std::string_view stream, size_t size, int window_bits);

}  // namespace slicefarm::gcode
