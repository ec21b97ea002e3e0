#include "services/slicing/sandbox/reader_limits.h"

#include <algorithm>

namespace slicefarm::slicing {
namespace {

constexpr int64_t kMib = int64_t{1} << 20;
constexpr int64_t kProgramBytes = 64 * kMib;  ///< code, libraries and stack
constexpr int64_t kMemoryPerFileByte = 32;
/// For the most triangles and vertices that limits.h lets a file have.
constexpr int64_t kMostMemory = 8192 * kMib;
constexpr int64_t kBaseCpuS = 10;
constexpr int64_t kFileBytesPerCpuS = 10 * kMib;

}  // namespace

ReaderLimits ReaderLimitsFor(int64_t file_bytes) {
  const int64_t for_triangles = std::min(kMemoryPerFileByte * file_bytes, kMostMemory);
  return {.memory_bytes = kProgramBytes + file_bytes + for_triangles,
          .cpu_s = kBaseCpuS + file_bytes / kFileBytesPerCpuS};
}

}  // namespace slicefarm::slicing
