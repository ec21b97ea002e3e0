#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm::coordinator {

/// A file descriptor, and the calls that durable files are made of. Short writes and EINTR are seen
/// to; other errors are DISK_FULL (no space, quota) or STORE_FAILED, naming the path.
class PosixFile {
 public:
  /// Errors also: NotFound.
  static absl::StatusOr<PosixFile> OpenToRead(const std::string& path);
  /// To read and write; created if it does not exist.
  static absl::StatusOr<PosixFile> OpenToWrite(const std::string& path);
  PosixFile(PosixFile&& other) noexcept;
  PosixFile& operator=(PosixFile&& other) noexcept;
  ~PosixFile();

  absl::StatusOr<int64_t> Size() const;
  absl::Status WriteAt(int64_t offset, std::string_view bytes) const;
  /// Up to `limit` bytes; fewer only at the end of the file.
  absl::StatusOr<std::string> ReadAt(int64_t offset, int64_t limit) const;
  absl::Status Truncate(int64_t size) const;
  absl::Status Sync() const;

 private:
  PosixFile(int fd, std::string path) : fd_(fd), path_(std::move(path)) {}

  int fd_ = -1;
  std::string path_;
};

/// Makes a directory (with its parents) that survives a power cut.
absl::Status MakeDirectory(const std::string& path);

/// rename, then fsync of the directory that holds `to`.
absl::Status RenameDurably(const std::string& from, const std::string& to);

/// Removes a file; OK if there is none.
absl::Status RemoveFile(const std::string& path);

}  // namespace slicefarm::coordinator
