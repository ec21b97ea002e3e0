#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "services/coordinator/store/sql/database_fill.h"

namespace slicefarm::coordinator {

/// How many bytes more there is room for; none: it cannot be asked, which is left to the writes,
/// which tell better.
using FreeBytes = std::function<std::optional<int64_t>()>;

/// Of the disk of a directory.
FreeBytes FreeOnDisk(std::string directory);

/// Of a database that is to have `max_bytes` at most. It is asked again when its last answer is
/// older than `every`. Thread-safe.
FreeBytes FreeInDatabase(std::function<absl::StatusOr<DatabaseFill>()> fill, int64_t max_bytes,
                         std::chrono::seconds every = std::chrono::seconds(10));

/// Keeps where the state is from filling up with what is yet to come, so that the jobs which are
/// there can be ended.
class DiskGuard {
 public:
  /// Without `free` there is always room. `min_free_bytes` 0: whatever fits.
  DiskGuard(FreeBytes free, int64_t min_free_bytes)
      : free_(std::move(free)), min_free_bytes_(min_free_bytes) {}

  /// For so many bytes more. Errors: DISK_LOW, with the time after which to try again.
  absl::Status CheckRoom(int64_t bytes = 0) const;

 private:
  const FreeBytes free_;
  const int64_t min_free_bytes_;
};

}  // namespace slicefarm::coordinator
