#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "services/coordinator/store/sql/database_fill.h"

namespace slicefarm::coordinator {

/// Function that returns the free bytes of a store, or nullopt if they are unknown. If they are
/// unknown, a full store is noticed only when a write fails.
using FreeBytes = std::function<std::optional<int64_t>()>;

/// Returns a function for the free bytes on the disk of a directory.
FreeBytes FreeOnDisk(std::string directory);

/// Returns a function for the free bytes of a database that may have at most `max_bytes`. `fill`
/// measures the database; it is called again when its last result is older than `every`.
/// Thread-safe.
FreeBytes FreeInDatabase(std::function<absl::StatusOr<DatabaseFill>()> fill, int64_t max_bytes,
                         std::chrono::seconds every = std::chrono::seconds(10));

/// Refuses new data when a store is nearly full, so that the existing jobs can end.
class DiskGuard {
 public:
  /// Creates a guard. If the function `free` is empty, there is always enough space. If
  /// `min_free_bytes` is 0, the guard accepts all data that fits.
  DiskGuard(FreeBytes free, int64_t min_free_bytes)
      : free_(std::move(free)), min_free_bytes_(min_free_bytes) {}

  /// Checks that `bytes` more bytes may be stored. Errors: DISK_LOW, with the time after which to
  /// retry.
  absl::Status CheckSpace(int64_t bytes = 0) const;

 private:
  const FreeBytes free_;
  const int64_t min_free_bytes_;
};

}  // namespace slicefarm::coordinator
