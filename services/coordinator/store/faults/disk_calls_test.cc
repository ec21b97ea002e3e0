#include "services/coordinator/store/faults/disk_calls_test.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <utility>

namespace slicefarm::coordinator {
namespace {

using Kind = DiskChange::Kind;

DiskCalls* g_calls = nullptr;

int ErrnoOf(Fault fault) {
  switch (fault) {
    case Fault::kEio:
      return EIO;
    case Fault::kQuota:
      return EDQUOT;
    case Fault::kEintr:
      return EINTR;
    default:
      return ENOSPC;
  }
}

// Faults that may occur in a call that reads.
const std::vector<Fault> kReads = {Fault::kEio, Fault::kEintr, Fault::kShort};
const std::vector<Fault> kOpens = {Fault::kEio, Fault::kEintr};
const std::vector<Fault> kWrites = {Fault::kEio, Fault::kNoSpace, Fault::kQuota, Fault::kEintr,
                                    Fault::kShort};
const std::vector<Fault> kCreates = {Fault::kEio, Fault::kNoSpace, Fault::kQuota, Fault::kEintr};
const std::vector<Fault>& kSyncs = kCreates;
const std::vector<Fault> kNames = {Fault::kEio, Fault::kNoSpace, Fault::kQuota};
const std::vector<Fault> kRemoves = {Fault::kEio};

}  // namespace

std::string_view FaultName(Fault fault) {
  constexpr std::string_view kNamesOf[] = {"EIO", "ENOSPC", "EDQUOT", "EINTR", "half"};
  return kNamesOf[static_cast<int>(fault)];
}

DiskCalls::DiskCalls(std::string root, Lie lie)
    : root_(std::move(root)), lie_(lie), before_(CrashDisk::Of(root_)), disk_(before_) {
  if (g_calls != nullptr) std::abort();
  g_calls = this;
}

DiskCalls::~DiskCalls() { g_calls = nullptr; }

void DiskCalls::FailAt(int64_t call, Fault fault, bool lasts) {
  fail_at_ = call;
  fault_ = fault;
  lasts_ = lasts;
}

void DiskCalls::Heal() {
  failing_ = false;
  fail_at_ = -1;
}

void DiskCalls::Damage(const std::string& path, int64_t offset, const std::string& bytes) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(offset);
  file << bytes;
  Note({.kind = Kind::kDamage, .node = *disk_.Find(Below(path)), .offset = offset, .bytes = bytes});
}

bool DiskCalls::Holds(std::string_view path) const {
  return path.starts_with(root_) && (path.size() == root_.size() || path[root_.size()] == '/');
}

std::string DiskCalls::Below(std::string_view path) const {
  return std::string(path.substr(std::min(path.size(), root_.size() + 1)));
}

DiskCalls::Place DiskCalls::PlaceOf(std::string_view path) const {
  const std::filesystem::path below = Below(path);
  return {disk_.Find(below.parent_path().native()).value(), below.filename()};
}

void DiskCalls::Note(DiskChange change) {
  disk_.Apply(change);
  changes_.push_back(std::move(change));
}

int DiskCalls::Strike(const char* function, std::string_view path, std::vector<Fault> faults,
                      size_t* bytes) {
  const bool at = static_cast<int64_t>(calls_.size()) == fail_at_;
  const bool can = std::find(faults.begin(), faults.end(), fault_) != faults.end();
  calls_.push_back({function, std::string(path), std::move(faults)});
  if (failing_ && fault_ == Fault::kShort) return can && function[0] != 'r' ? ENOSPC : 0;
  if (!can || !(at || failing_)) return 0;
  failing_ = lasts_;
  struck_ = true;
  if (fault_ != Fault::kShort) return ErrnoOf(fault_);
  *bytes = (*bytes + 1) / 2;
  return 0;
}

/// Replacements of functions of the C library, as this program and its libraries find them.
class LibcHooks {
 public:
  static int Open(const char* path, int flags, int mode) {
    DiskCalls* const calls = For(path);
    const auto system = [&] {
      return static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, flags, mode));
    };
    if (calls == nullptr) return system();
    const bool creates = (flags & O_CREAT) != 0 && !calls->disk_.Find(calls->Below(path));
    if (Fails(calls->Strike("open", calls->Below(path), creates ? kCreates : kOpens, nullptr))) {
      return -1;
    }
    const int fd = system();
    if (fd < 0) return fd;
    if (creates) {
      const auto [directory, name] = calls->PlaceOf(path);
      calls->Note({.kind = Kind::kCreate,
                   .node = calls->disk_.next_node(),
                   .parent = directory,
                   .name = name});
    }
    calls->files_[fd] = {calls->disk_.Find(calls->Below(path)).value(), calls->Below(path)};
    if ((flags & O_TRUNC) != 0) NoteTruncated(*calls, fd, 0);
    return fd;
  }

  static int Close(int fd) {
    if (g_calls != nullptr) g_calls->files_.erase(fd);
    return static_cast<int>(syscall(SYS_close, fd));
  }

  static ssize_t Read(int fd, void* bytes, size_t count, off_t offset) {
    DiskCalls* const calls = For(fd);
    if (calls != nullptr && Fails(Strike(*calls, "read", fd, kReads, &count))) return -1;
    return syscall(SYS_pread64, fd, bytes, count, offset);
  }

  static ssize_t Write(int fd, const void* bytes, size_t count, off_t offset) {
    DiskCalls* const calls = For(fd);
    if (calls != nullptr && Fails(Strike(*calls, "write", fd, kWrites, &count))) return -1;
    const ssize_t written = syscall(SYS_pwrite64, fd, bytes, count, offset);
    if (calls != nullptr && written > 0) {
      calls->Note({.kind = Kind::kWrite,
                   .node = calls->files_[fd].node,
                   .offset = offset,
                   .bytes = std::string(static_cast<const char*>(bytes), written)});
    }
    return written;
  }

  /// Makes a call at the position of the file where it is read and written.
  template <typename Call>
  static ssize_t Sequential(int fd, const Call& call) {
    const off_t at = lseek(fd, 0, SEEK_CUR);
    const ssize_t count = call(at);
    if (count > 0) lseek(fd, at + count, SEEK_SET);
    return count;
  }
  static bool Watches(int fd) { return For(fd) != nullptr; }

  static int Truncate(int fd, off_t size) {
    DiskCalls* const calls = For(fd);
    if (calls != nullptr && Fails(Strike(*calls, "truncate", fd, kOpens, nullptr))) return -1;
    const int result = static_cast<int>(syscall(SYS_ftruncate, fd, size));
    if (calls != nullptr && result == 0) NoteTruncated(*calls, fd, size);
    return result;
  }

  static int Sync(int fd) {
    DiskCalls* const calls = For(fd);
    if (calls == nullptr) return static_cast<int>(syscall(SYS_fsync, fd));
    const int node = calls->files_[fd].node;
    const int error = Strike(*calls, "sync", fd, kSyncs, nullptr);
    if (Fails(error)) {
      if (error != EINTR) calls->Note({.kind = Kind::kSyncFailed, .node = node});
      return -1;
    }
    const Lie lie = calls->disk_.IsDirectory(node) ? Lie::kDirectories : Lie::kFiles;
    if (calls->lie_ != lie) calls->Note({.kind = Kind::kSync, .node = node});
    return 0;
  }

  static int Rename(const char* from, const char* to) {
    DiskCalls* const calls = For(from);
    if (calls != nullptr && Fails(calls->Strike("rename", calls->Below(from), kNames, nullptr))) {
      return -1;
    }
    const int result = static_cast<int>(syscall(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to));
    if (calls == nullptr || result != 0) return result;
    // A rename between two names of one file does nothing.
    if (faccessat(AT_FDCWD, from, F_OK, 0) == 0) return 0;
    const auto source = calls->PlaceOf(from), target = calls->PlaceOf(to);
    calls->Note({.kind = Kind::kRename,
                 .parent = source.directory,
                 .name = source.name,
                 .to_parent = target.directory,
                 .to_name = target.name});
    return 0;
  }

  static int Remove(const char* path, int flags) {
    DiskCalls* const calls = For(path);
    if (calls != nullptr && Fails(calls->Strike("unlink", calls->Below(path), kRemoves, nullptr))) {
      return -1;
    }
    const int result = static_cast<int>(syscall(SYS_unlinkat, AT_FDCWD, path, flags));
    if (calls == nullptr || result != 0) return result;
    const auto [directory, name] = calls->PlaceOf(path);
    calls->Note({.kind = Kind::kUnlink, .parent = directory, .name = name});
    return 0;
  }

  static int MakeDirectory(const char* path, mode_t mode) {
    DiskCalls* const calls = For(path);
    if (calls != nullptr && Fails(calls->Strike("mkdir", calls->Below(path), kNames, nullptr))) {
      return -1;
    }
    const int result = static_cast<int>(syscall(SYS_mkdirat, AT_FDCWD, path, mode));
    if (calls == nullptr || result != 0) return result;
    const auto [directory, name] = calls->PlaceOf(path);
    calls->Note({.kind = Kind::kMakeDirectory,
                 .node = calls->disk_.next_node(),
                 .parent = directory,
                 .name = name});
    return 0;
  }

  static int SetTimes(int directory, const char* path, const struct timespec* times, int flags) {
    DiskCalls* const calls = path == nullptr ? nullptr : For(path);
    if (calls != nullptr && Fails(calls->Strike("touch", calls->Below(path), kRemoves, nullptr))) {
      return -1;
    }
    return static_cast<int>(syscall(SYS_utimensat, directory, path, times, flags));
  }

 private:
  static DiskCalls* For(const char* path) {
    return g_calls != nullptr && g_calls->Holds(path) ? g_calls : nullptr;
  }
  static DiskCalls* For(int fd) {
    return g_calls != nullptr && g_calls->Holds(fd) ? g_calls : nullptr;
  }

  static int Strike(DiskCalls& calls, const char* function, int fd,
                    const std::vector<Fault>& faults, size_t* bytes) {
    return calls.Strike(function, calls.files_[fd].path, faults, bytes);
  }

  static bool Fails(int error) {
    if (error != 0) errno = error;
    return error != 0;
  }

  static void NoteTruncated(DiskCalls& calls, int fd, off_t size) {
    calls.Note({.kind = Kind::kTruncate, .node = calls.files_[fd].node, .offset = size});
  }
};

std::vector<std::string> DiskCalls::Functions() {
  return {"open",      "open64", "close",    "read",      "pread",       "pread64",
          "write",     "pwrite", "pwrite64", "ftruncate", "ftruncate64", "fsync",
          "fdatasync", "rename", "unlink",   "rmdir",     "mkdir",       "utimensat"};
}

}  // namespace slicefarm::coordinator

// A definition in the program takes precedence over that of a library, also for other libraries.
extern "C" {

using slicefarm::coordinator::LibcHooks;

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const int mode = va_arg(rest, int);  // most calls ignore this argument
  va_end(rest);
  return LibcHooks::Open(path, flags, mode);
}
int open64(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const int mode = va_arg(rest, int);
  va_end(rest);
  return LibcHooks::Open(path, flags, mode);
}
int close(int fd) { return LibcHooks::Close(fd); }
ssize_t read(int fd, void* to, size_t count) {
  if (!LibcHooks::Watches(fd)) return syscall(SYS_read, fd, to, count);
  return LibcHooks::Sequential(fd, [&](off_t at) { return LibcHooks::Read(fd, to, count, at); });
}
ssize_t write(int fd, const void* from, size_t count) {
  if (!LibcHooks::Watches(fd)) return syscall(SYS_write, fd, from, count);
  return LibcHooks::Sequential(fd, [&](off_t at) { return LibcHooks::Write(fd, from, count, at); });
}
ssize_t pread(int fd, void* to, size_t count, off_t at) {
  return LibcHooks::Read(fd, to, count, at);
}
ssize_t pread64(int fd, void* to, size_t count, off64_t at) {
  return LibcHooks::Read(fd, to, count, at);
}
ssize_t pwrite(int fd, const void* from, size_t count, off_t at) {
  return LibcHooks::Write(fd, from, count, at);
}
ssize_t pwrite64(int fd, const void* from, size_t count, off64_t at) {
  return LibcHooks::Write(fd, from, count, at);
}
int ftruncate(int fd, off_t size) noexcept { return LibcHooks::Truncate(fd, size); }
int ftruncate64(int fd, off64_t size) noexcept { return LibcHooks::Truncate(fd, size); }
int fsync(int fd) { return LibcHooks::Sync(fd); }
int fdatasync(int fd) { return LibcHooks::Sync(fd); }
int rename(const char* from, const char* to) noexcept { return LibcHooks::Rename(from, to); }
int unlink(const char* path) noexcept { return LibcHooks::Remove(path, 0); }
int rmdir(const char* path) noexcept { return LibcHooks::Remove(path, AT_REMOVEDIR); }
int mkdir(const char* path, mode_t mode) noexcept { return LibcHooks::MakeDirectory(path, mode); }
int utimensat(int directory, const char* path, const struct timespec times[2], int flags) noexcept {
  return LibcHooks::SetTimes(directory, path, times, flags);
}
}
