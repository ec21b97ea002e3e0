#pragma once

#include <cstdint>
#include <string_view>

namespace slicefarm::slicing {

/// What one reader process may use.
struct ReaderLimits {
  int64_t memory_bytes = 0;  ///< of address space, its program and the file included
  int64_t cpu_s = 0;

  friend bool operator==(const ReaderLimits&, const ReaderLimits&) = default;
};

/// Generous for any file within limits.h, whatever is in it: the most hostile OBJ takes 20 bytes of
/// memory for each of its own while it is read, and the slowest format 10 ns. A 3MF's text may be
/// limits::kMaxCompressionRatio times as long as the file, though few are beyond 20 times.
ReaderLimits ReaderLimitsFor(std::string_view file);

}  // namespace slicefarm::slicing
