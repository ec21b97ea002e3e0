#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace slicefarm::coordinator {

/// The 512 bytes that stand before a file in a tar archive (POSIX ustar). After the file come zeros
/// up to a multiple of 512 (TarPadding), after the last one TarEnd(). `time_s`: since 1970.
/// REQUIRES: a name of 1 to 100 bytes; 0 <= size < 8 GiB.
std::string TarHeader(std::string_view name, int64_t size, int64_t time_s);

/// The zeros after a file of `size` bytes.
std::string TarPadding(int64_t size);

std::string TarEnd();

}  // namespace slicefarm::coordinator
