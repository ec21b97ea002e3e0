#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm {

/// Temporary file without a name, for data that may be too large for memory. Texts are appended and
/// can be read any number of times. The system keeps the bytes in its cache as long as there is
/// space. The file disappears with this object, even if the program crashes. Thread-safe.
class SpoolFile {
 public:
  /// Position and length of a text in the file, in bytes.
  struct Chunk {
    int64_t offset = 0;
    int64_t size = 0;
  };

  /// Makes a file in an existing directory; an empty `directory` is the system's directory for
  /// temporary files. Errors of all functions of the class: DISK_FULL if the disk has no space;
  /// STORE_FAILED for any other failure of the system.
  static absl::StatusOr<std::unique_ptr<SpoolFile>> Make(const std::string& directory);
  SpoolFile(const SpoolFile&) = delete;
  SpoolFile& operator=(const SpoolFile&) = delete;
  ~SpoolFile();

  absl::StatusOr<Chunk> Add(std::string_view text);

  /// Fills `bytes` with the file's data from `offset` on. Returns STORE_FAILED if the file has
  /// fewer bytes after `offset`.
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
