#pragma once

#include <cstdint>
#include <string_view>

namespace slicefarm::slicing {

/// Resources that one run of the reader program may use.
struct ReaderLimits {
  /// size of the address space, including the reader's program and the file
  int64_t memory_bytes = 0;
  int64_t cpu_s = 0;

  friend bool operator==(const ReaderLimits&, const ReaderLimits&) = default;
};

/// Returns limits that suffice for any file within limits.h. The most hostile OBJ needs 20 bytes of
/// memory per byte of the file while it is read; the slowest format needs 10 ns per byte. The text
/// of a 3MF may be limits::kMaxCompressionRatio times as long as the file, but it is rarely more
/// than 20 times as long.
ReaderLimits ReaderLimitsFor(std::string_view file);

}  // namespace slicefarm::slicing
