#include "common/base/spool_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include "common/base/error.h"

namespace slicefarm {
namespace {

absl::Status SpoolError(const char* what, const std::string& directory, int error) {
  const std::string message =
      fmt::format("{} a temporary file in {}: {}", what, directory, std::strerror(error));
  if (error == ENOSPC || error == EDQUOT || error == EFBIG)
    return MakeError(absl::StatusCode::kResourceExhausted, Reason::kDiskFull, message);
  return MakeError(absl::StatusCode::kInternal, Reason::kStoreFailed, message);
}

/// Opens a file without a name. If the file system does not support this, the file is created with
/// a name that is removed at once.
int OpenNameless(const std::string& directory) {
  const int descriptor = open(directory.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (descriptor >= 0 || (errno != EOPNOTSUPP && errno != EISDIR)) return descriptor;
  std::string name = directory + "/spool-XXXXXX";
  const int named = mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0) unlink(name.c_str());
  return named;
}

}  // namespace

absl::StatusOr<std::unique_ptr<SpoolFile>> SpoolFile::Make(const std::string& directory) {
  std::string where = directory;
  std::error_code none;
  if (where.empty()) where = std::filesystem::temp_directory_path(none);
  if (none) return SpoolError("make", "TMPDIR", none.value());
  const int descriptor = OpenNameless(where);
  if (descriptor < 0) return SpoolError("make", where, errno);
  return std::unique_ptr<SpoolFile>(new SpoolFile(descriptor, std::move(where)));
}

SpoolFile::~SpoolFile() { close(descriptor_); }

absl::Status SpoolFile::Error(const char* what) const {
  return SpoolError(what, directory_, errno);
}

absl::StatusOr<SpoolFile::Chunk> SpoolFile::Add(std::string_view text) {
  const auto size = static_cast<int64_t>(text.size());
  const Chunk chunk{end_.fetch_add(size), size};
  for (int64_t at = chunk.offset; !text.empty();) {
    const ssize_t n = pwrite(descriptor_, text.data(), text.size(), at);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return Error("write");
    text.remove_prefix(static_cast<size_t>(n));
    at += n;
  }
  return chunk;
}

absl::Status SpoolFile::ReadAt(int64_t offset, std::span<char> bytes) const {
  while (!bytes.empty()) {
    const ssize_t n = pread(descriptor_, bytes.data(), bytes.size(), offset);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return Error("read");
    if (n == 0) return SpoolError("read to the end of", directory_, EIO);
    bytes = bytes.subspan(static_cast<size_t>(n));
    offset += n;
  }
  return absl::OkStatus();
}

}  // namespace slicefarm
