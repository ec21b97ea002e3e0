#pragma once

#include <memory>
#include <string>

#include "absl/status/statusor.h"

namespace slicefarm::coordinator {

/// Lock that prevents a second coordinator from using the same state directory. The system releases
/// it at the end of the program, even after a crash.
class StateLock {
 public:
  /// Takes the lock. Errors: Unavailable if another program has it; STORE_FAILED.
  static absl::StatusOr<std::unique_ptr<StateLock>> Take(const std::string& directory);
  ~StateLock();
  StateLock(const StateLock&) = delete;
  StateLock& operator=(const StateLock&) = delete;

 private:
  explicit StateLock(int fd) : fd_(fd) {}
  const int fd_;
};

}  // namespace slicefarm::coordinator
