#include "services/coordinator/store/disk/posix_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"

namespace slicefarm::coordinator {
namespace {

constexpr int64_t kCopyBytes = 1 << 20;

absl::Status ErrnoError(const char* what, const std::string& path) {
  const int error = errno;
  const std::string message = absl::StrCat(what, " ", path, ": ", std::strerror(error));
  switch (error) {
    case ENOENT:
      return MakeError(absl::StatusCode::kNotFound, Reason::kBlobNotFound, message);
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return MakeError(absl::StatusCode::kResourceExhausted, Reason::kDiskFull, message);
    default:
      return MakeError(absl::StatusCode::kInternal, Reason::kStoreFailed, message);
  }
}

template <typename Call>
auto Retry(const Call& call) {
  auto result = call();
  while (result < 0 && errno == EINTR) result = call();
  return result;
}

}  // namespace

absl::StatusOr<PosixFile> PosixFile::OpenToRead(const std::string& path) {
  const int fd = Retry([&] { return open(path.c_str(), O_RDONLY | O_CLOEXEC); });
  if (fd < 0) return ErrnoError("open", path);
  return PosixFile(fd, path);
}

absl::StatusOr<PosixFile> PosixFile::OpenToWrite(const std::string& path) {
  const int fd = Retry([&] { return open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0640); });
  if (fd < 0) return ErrnoError("open", path);
  return PosixFile(fd, path);
}

PosixFile::PosixFile(PosixFile&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)), path_(std::move(other.path_)) {}

PosixFile& PosixFile::operator=(PosixFile&& other) noexcept {
  std::swap(fd_, other.fd_);
  std::swap(path_, other.path_);
  return *this;
}

PosixFile::~PosixFile() {
  if (fd_ >= 0) close(fd_);
}

absl::StatusOr<int64_t> PosixFile::Size() const {
  struct stat info;
  if (fstat(fd_, &info) != 0) return ErrnoError("stat", path_);
  return info.st_size;
}

absl::Status PosixFile::WriteAt(int64_t offset, std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t n = Retry([&] { return pwrite(fd_, bytes.data(), bytes.size(), offset); });
    if (n < 0) return ErrnoError("write", path_);
    bytes.remove_prefix(n);
    offset += n;
  }
  return absl::OkStatus();
}

absl::StatusOr<std::string> PosixFile::ReadAt(int64_t offset, int64_t limit) const {
  std::string bytes(limit, '\0');
  int64_t got = 0;
  while (got < limit) {
    const ssize_t n =
        Retry([&] { return pread(fd_, bytes.data() + got, limit - got, offset + got); });
    if (n < 0) return ErrnoError("read", path_);
    if (n == 0) break;
    got += n;
  }
  bytes.resize(got);
  return bytes;
}

absl::Status PosixFile::Truncate(int64_t size) const {
  if (Retry([&] { return ftruncate(fd_, size); }) == 0) return absl::OkStatus();
  return ErrnoError("truncate", path_);
}

absl::Status PosixFile::Sync() const {
  if (Retry([&] { return fsync(fd_); }) == 0) return absl::OkStatus();
  return ErrnoError("fsync", path_);
}

absl::Status PosixFile::SyncAnew() const {
  for (int64_t offset = 0;;) {
    const auto bytes = ReadAt(offset, kCopyBytes);
    if (!bytes.ok()) return bytes.status();
    if (bytes->empty()) return Sync();
    if (absl::Status written = WriteAt(offset, *bytes); !written.ok()) return written;
    offset += static_cast<int64_t>(bytes->size());
  }
}

std::string ParentOf(const std::string& path) {
  const std::string parent = std::filesystem::path(path).parent_path();
  return parent.empty() ? "." : parent;
}

absl::Status MakeDirectory(const std::string& path) {
  const std::string parent = ParentOf(path);
  std::error_code ignored;  // mkdir reports the error
  if (!std::filesystem::is_directory(path, ignored)) {
    if (parent != path) {
      if (absl::Status made = MakeDirectory(parent); !made.ok()) return made;
    }
    if (mkdir(path.c_str(), 0750) != 0 && errno != EEXIST) return ErrnoError("mkdir", path);
  } else if (access(parent.c_str(), R_OK) != 0) {
    return absl::OkStatus();  // this program cannot have created the directory
  }
  // An existing directory needs the fsync as well, because the program that created it may have
  // ended before its fsync.
  return SyncDirectory(parent);
}

absl::Status SyncDirectory(const std::string& path) {
  const auto directory = PosixFile::OpenToRead(path);
  if (!directory.ok()) return directory.status();
  return directory->Sync();
}

absl::Status RenameFile(const std::string& from, const std::string& to) {
  if (rename(from.c_str(), to.c_str()) == 0) return absl::OkStatus();
  return ErrnoError("rename", from);
}

absl::Status TouchFile(const std::string& path) {
  if (utimensat(AT_FDCWD, path.c_str(), nullptr, 0) == 0 || errno == ENOENT) {
    return absl::OkStatus();
  }
  return ErrnoError("touch", path);
}

absl::Status RemoveFile(const std::string& path) {
  if (unlink(path.c_str()) == 0 || errno == ENOENT) return absl::OkStatus();
  return ErrnoError("unlink", path);
}

}  // namespace slicefarm::coordinator
