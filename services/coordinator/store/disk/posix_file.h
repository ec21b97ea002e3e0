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
  /// Writes every byte over itself, and syncs. A plain Sync says nothing of bytes that an earlier
  /// fsync could not write: the kernel tells it once, and calls them written from then on.
  absl::Status SyncAnew() const;

 private:
  PosixFile(int fd, std::string path) : fd_(fd), path_(std::move(path)) {}

  int fd_ = -1;
  std::string path_;
};

/// Makes a directory (with its parents) that survives a power cut; one that is there does so
/// afterwards, too.
absl::Status MakeDirectory(const std::string& path);

/// The directory that a file is in: "." for a name alone.
std::string ParentOf(const std::string& path);

/// fsync of a directory: the names in it are on disk.
absl::Status SyncDirectory(const std::string& path);

/// A power cut may undo it, before SyncDirectory of where `to` is.
absl::Status RenameFile(const std::string& from, const std::string& to);

/// So that it was written just now; OK if there is none.
absl::Status TouchFile(const std::string& path);

/// Removes a file; OK if there is none.
absl::Status RemoveFile(const std::string& path);

}  // namespace slicefarm::coordinator
