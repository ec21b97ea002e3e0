#include "services/cli/console/input_files.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <cstdint>
#include <mutex>
#include <optional>
#include <set>
#include <tuple>

namespace slicefarm::cli {
namespace {

/// Device, inode, and time of birth. The time is 0 if the file system does not have it.
using FileId = std::tuple<uint32_t, uint32_t, uint64_t, int64_t, uint32_t>;

struct Inputs {
  std::mutex mutex;
  std::set<FileId> files;
};

Inputs& All() {
  static Inputs inputs;
  return inputs;
}

/// Returns the id of a file; nullopt if it is no regular file.
std::optional<FileId> IdOf(int descriptor, const char* path, int flags) {
  struct statx file = {};
  if (statx(descriptor, path, flags, STATX_TYPE | STATX_INO | STATX_BTIME, &file) != 0)
    return std::nullopt;
  if (!S_ISREG(file.stx_mode)) return std::nullopt;
  return FileId(file.stx_dev_major, file.stx_dev_minor, file.stx_ino, file.stx_btime.tv_sec,
                file.stx_btime.tv_nsec);
}

void Note(const std::optional<FileId>& id) {
  if (!id) return;
  const std::lock_guard lock(All().mutex);
  All().files.insert(*id);
}

}  // namespace

void NoteInput(int descriptor) { Note(IdOf(descriptor, "", AT_EMPTY_PATH)); }

void NoteInput(const std::string& path) { Note(IdOf(AT_FDCWD, path.c_str(), 0)); }

bool IsInput(const std::string& path) {
  const auto id = IdOf(AT_FDCWD, path.c_str(), 0);
  if (!id) return false;
  const std::lock_guard lock(All().mutex);
  return All().files.contains(*id);
}

}  // namespace slicefarm::cli
