#include "services/slicing/sandbox/request_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "common/base/error.h"

namespace slicefarm::slicing {
namespace {

/// Number of bytes copied between two checks for cancellation; this takes some milliseconds.
constexpr size_t kBytesPerPoll = 16 << 20;

absl::Status NoMemory(int error) {
  return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                   fmt::format("cannot hand the mesh to its reader: {}", strerrordesc_np(error)));
}

absl::Status Append(const Fd& file, std::string_view bytes, const CancelToken& cancel) {
  while (!bytes.empty()) {
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    const ssize_t size = write(file.number(), bytes.data(), std::min(bytes.size(), kBytesPerPoll));
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) return NoMemory(errno);
    bytes.remove_prefix(static_cast<size_t>(size));
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<Fd> MakeRequestFile(const RequestHead& head, std::string_view bytes,
                                   const CancelToken& cancel) {
  Fd file(memfd_create("mesh", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (file.number() < 0) return NoMemory(errno);
  const std::string_view front(reinterpret_cast<const char*>(&head), sizeof head);
  for (const std::string_view part : {front, bytes})
    if (absl::Status status = Append(file, part, cancel); !status.ok()) return status;
  constexpr int kAll = F_SEAL_WRITE | F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL;
  if (fcntl(file.number(), F_ADD_SEALS, kAll) != 0) return NoMemory(errno);
  return file;
}

}  // namespace slicefarm::slicing
