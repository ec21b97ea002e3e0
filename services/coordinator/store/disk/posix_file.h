#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm::coordinator {

/// File descriptor with the calls that durable files need. Handles short writes and EINTR. Errors
/// of all functions of this file: DISK_FULL (no space, quota) or STORE_FAILED, with the path.
class PosixFile {
 public:
  /// Opens a file for reading. Errors: also NotFound.
  static absl::StatusOr<PosixFile> OpenToRead(const std::string& path);
  /// Opens a file for reading and writing. Creates it if it does not exist.
  static absl::StatusOr<PosixFile> OpenToWrite(const std::string& path);
  PosixFile(PosixFile&& other) noexcept;
  PosixFile& operator=(PosixFile&& other) noexcept;
  ~PosixFile();

  /// Returns the size of the file.
  absl::StatusOr<int64_t> Size() const;
  /// Writes the bytes at `offset`.
  absl::Status WriteAt(int64_t offset, std::string_view bytes) const;
  /// Returns up to `limit` bytes; fewer only at the end of the file.
  absl::StatusOr<std::string> ReadAt(int64_t offset, int64_t limit) const;
  /// Cuts the file to `size` bytes.
  absl::Status Truncate(int64_t size) const;
  /// Writes the bytes of the file to disk (fsync).
  absl::Status Sync() const;
  /// Writes every byte of the file again, and syncs. Needed after a failed fsync: the kernel
  /// reports the lost bytes only once and then treats them as written, so a plain Sync would not
  /// notice them.
  absl::Status SyncAnew() const;

 private:
  PosixFile(int fd, std::string path) : fd_(fd), path_(std::move(path)) {}

  int fd_ = -1;
  std::string path_;
};

/// Creates a directory and its parents, and syncs them, so that they survive a power cut. Also
/// syncs a directory that already exists.
absl::Status MakeDirectory(const std::string& path);

/// Returns the directory that contains a file; "." for a name without a directory.
std::string ParentOf(const std::string& path);

/// Calls fsync for a directory; afterwards the names in it are on disk.
absl::Status SyncDirectory(const std::string& path);

/// Renames a file. A power cut may undo the renaming until SyncDirectory was called for the
/// directory of `to`.
absl::Status RenameFile(const std::string& from, const std::string& to);

/// Sets the file's modification time to now. Returns OK if the file does not exist.
absl::Status TouchFile(const std::string& path);

/// Removes a file. Returns OK if it does not exist.
absl::Status RemoveFile(const std::string& path);

}  // namespace slicefarm::coordinator
