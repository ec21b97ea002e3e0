#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace slicefarm::coordinator {

/// Returns the 512-byte header that precedes a file of `size` bytes in a tar archive (POSIX ustar).
/// Write the header, the file and TarPadding for each file, and TarEnd at the end of the archive.
/// `time_s`: seconds since 1970. REQUIRES: a name of 1 to 100 bytes; 0 <= size < 8 GiB.
std::string TarHeader(std::string_view name, int64_t size, int64_t time_s);

/// Returns the zeros that follow a file of `size` bytes, up to a multiple of 512.
std::string TarPadding(int64_t size);

/// Returns the end of an archive.
std::string TarEnd();

}  // namespace slicefarm::coordinator
