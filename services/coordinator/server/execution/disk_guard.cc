#include "services/coordinator/server/execution/disk_guard.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <mutex>
#include <system_error>

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::coordinator {
namespace {

/// Last answer of a database, and the time until which it is valid.
struct Asked {
  std::mutex mutex;
  std::chrono::steady_clock::time_point until;
  std::optional<int64_t> free;
};

}  // namespace

FreeBytes FreeOnDisk(std::string directory) {
  return [directory = std::move(directory)]() -> std::optional<int64_t> {
    std::error_code error;
    const std::filesystem::space_info space = std::filesystem::space(directory, error);
    if (error) return std::nullopt;
    return static_cast<int64_t>(space.available);
  };
}

FreeBytes FreeInDatabase(std::function<absl::StatusOr<DatabaseFill>()> fill, int64_t max_bytes,
                         std::chrono::seconds every) {
  const auto asked = std::make_shared<Asked>();  // shared by all copies of the function
  return [=]() -> std::optional<int64_t> {
    const std::lock_guard lock(asked->mutex);
    const auto now = std::chrono::steady_clock::now();
    if (now < asked->until) return asked->free;
    const auto is = fill();
    asked->free = is.ok() ? std::optional(max_bytes - is->bytes) : std::nullopt;
    asked->until = now + every;
    return asked->free;
  };
}

absl::Status DiskGuard::CheckSpace(int64_t bytes) const {
  if (!free_) return absl::OkStatus();
  const std::optional<int64_t> free = free_();
  if (!free || *free - bytes >= min_free_bytes_) return absl::OkStatus();
  return MakeError(
      absl::StatusCode::kResourceExhausted, Reason::kDiskLow,
      fmt::format("the server has {} MiB of free space; it accepts no new data below {} MiB",
                  std::max<int64_t>(0, *free) >> 20, min_free_bytes_ >> 20),
      {{"free_bytes", std::to_string(*free)},
       {"min_free_bytes", std::to_string(min_free_bytes_)},
       {rpc::kRetryAfterMs, "30000"}});
}

}  // namespace slicefarm::coordinator
