#include "services/slicing/sandbox/reader_limits.h"

#include <algorithm>

#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/threemf/threemf_reader.h"

namespace slicefarm::slicing {
namespace {

constexpr int64_t kMib = int64_t{1} << 20;
constexpr int64_t kProgramBytes = 64 * kMib;  ///< code, libraries and stack
constexpr int64_t kMemoryPerFileByte = 32;
/// Largest memory limit: enough for the largest numbers of triangles and vertices within limits.h.
constexpr int64_t kMostMemory = 8192 * kMib;
constexpr int64_t kBaseCpuS = 10;
constexpr int64_t kFileBytesPerCpuS = 10 * kMib;

// In an archive's text, a vertex takes 27 bytes and a triangle 32. In memory, each exists up to
// three times while its list grows.
constexpr int64_t kBaseArchiveMemory = 256 * kMib;
constexpr int64_t kMemoryPerArchiveByte = 80;
constexpr int64_t kTextBytesPerCpuS = 40 * kMib;

ReaderLimits ArchiveLimits(int64_t file_bytes) {
  const int64_t text_bytes =
      std::min(limits::kFreeExpandedBytes + limits::kMaxCompressionRatio * file_bytes,
               limits::kMaxExpandedArchiveBytes);
  const int64_t for_contents = std::min(kMemoryPerArchiveByte * file_bytes, kMostMemory);
  return {.memory_bytes = kProgramBytes + file_bytes + kBaseArchiveMemory + for_contents,
          .cpu_s = kBaseCpuS + text_bytes / kTextBytesPerCpuS};
}

}  // namespace

ReaderLimits ReaderLimitsFor(std::string_view file) {
  const auto file_bytes = static_cast<int64_t>(file.size());
  if (LooksLike3mf(file)) return ArchiveLimits(file_bytes);
  const int64_t for_triangles = std::min(kMemoryPerFileByte * file_bytes, kMostMemory);
  return {.memory_bytes = kProgramBytes + file_bytes + for_triangles,
          .cpu_s = kBaseCpuS + file_bytes / kFileBytesPerCpuS};
}

}  // namespace slicefarm::slicing
