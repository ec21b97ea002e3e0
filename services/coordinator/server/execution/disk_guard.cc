#include "services/coordinator/server/execution/disk_guard.h"

#include <fmt/core.h>

#include <filesystem>
#include <system_error>

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::coordinator {

absl::Status DiskGuard::CheckRoom(int64_t bytes) const {
  if (directory_.empty() || min_free_bytes_ == 0) return absl::OkStatus();
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(directory_, error);
  // What cannot be asked is left to the writes, which tell better.
  if (error || static_cast<int64_t>(space.available) - bytes >= min_free_bytes_)
    return absl::OkStatus();
  return MakeError(
      absl::StatusCode::kResourceExhausted, Reason::kDiskLow,
      fmt::format("{} MiB of the server's disk are free; it takes nothing new below {}",
                  space.available >> 20, min_free_bytes_ >> 20),
      {{"free_bytes", std::to_string(space.available)},
       {"min_free_bytes", std::to_string(min_free_bytes_)},
       {rpc::kRetryAfterMs, "30000"}});
}

}  // namespace slicefarm::coordinator
