#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm {

/// A file without a name for what would take too much memory: texts are added as they come, and
/// read back as often as need be. Its bytes are in the system's cache as long as there is room. It
/// goes with the object, whatever becomes of the process. Thread-safe.
class SpoolFile {
 public:
  /// Where a text lies. Any part of it may be read as well.
  struct Place {
    int64_t offset = 0;
    int64_t size = 0;
  };

  /// In a directory that is there; of no name: where the system has temporary files. Errors:
  /// DISK_FULL, STORE_FAILED, as for the other methods.
  static absl::StatusOr<std::unique_ptr<SpoolFile>> Make(const std::string& directory);
  SpoolFile(const SpoolFile&) = delete;
  SpoolFile& operator=(const SpoolFile&) = delete;
  ~SpoolFile();

  absl::StatusOr<Place> Add(std::string_view text);

  /// Fills `bytes` from `offset` on. Errors also: STORE_FAILED if the file ends before.
  absl::Status ReadAt(int64_t offset, std::span<char> bytes) const;

 private:
  SpoolFile(int descriptor, std::string directory)
      : descriptor_(descriptor), directory_(std::move(directory)) {}
  absl::Status Error(const char* what) const;

  const int descriptor_;
  const std::string directory_;
  std::atomic<int64_t> end_ = 0;
};

}  // namespace slicefarm
