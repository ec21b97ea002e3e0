#pragma once

#include <cstdint>
#include <string>

#include "absl/status/status.h"

namespace slicefarm::coordinator {

/// Keeps the disk of the state from filling up with what is yet to come, so that the jobs which are
/// there can be ended.
class DiskGuard {
 public:
  /// `directory` empty: the state is somewhere else, and there is always room. `min_free_bytes` 0:
  /// whatever fits.
  DiskGuard(std::string directory, int64_t min_free_bytes)
      : directory_(std::move(directory)), min_free_bytes_(min_free_bytes) {}

  /// For so many bytes more. Errors: DISK_LOW, with the time after which to try again.
  absl::Status CheckRoom(int64_t bytes = 0) const;

 private:
  const std::string directory_;
  const int64_t min_free_bytes_;
};

}  // namespace slicefarm::coordinator
