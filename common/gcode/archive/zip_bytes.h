#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::gcode {

/// File in a ZIP archive.
struct ZipMember {
  std::string name;  ///< name, with `/` between folders
  std::string data;
  bool deflated = true;  ///< false: the data are compressed already
};

/// Returns a ZIP archive with these files, in this order. The same files give the same bytes: all
/// have the first time that ZIP can express. Cost: O(bytes).
absl::StatusOr<std::string> ZipOf(const std::vector<ZipMember>& members);

/// Entry in the directory of an archive.
struct ZipEntryInfo {
  std::string name;
  uint64_t index = 0;
  uint64_t bytes = 0;         ///< expanded size
  uint64_t packed_bytes = 0;  ///< size in the archive
};

/// Limits on archives, which protect from archives that expand to much more than their size.
inline constexpr int64_t kMaxZipEntries = 10'000;
inline constexpr int64_t kMaxZipMemberBytes = int64_t{2} << 30;
inline constexpr int64_t kMaxZipRatio = 1'000;
inline constexpr int64_t kFreeZipBytes = 1 << 20;  ///< bytes to which any archive may expand

/// Returns the entries of an archive, in the order of its directory. Errors: InvalidArgument for
/// bytes that are no archive, and above kMaxZipEntries.
absl::StatusOr<std::vector<ZipEntryInfo>> ZipEntries(std::string_view archive);

/// Returns the data of an entry. Errors: InvalidArgument for damaged and encrypted entries, for
/// data that do not match the directory, and above kMaxZipMemberBytes and kMaxZipRatio.
absl::StatusOr<std::string> ZipData(std::string_view archive, const ZipEntryInfo& entry);

}  // namespace slicefarm::gcode
