#pragma once

#include <functional>
#include <utility>

#include "absl/status/status.h"

namespace slicefarm {

/// Asks whether the work is still wanted. Algorithms that can take over 50 ms poll it and return
/// Cancelled. Cheap to copy; safe to poll from any thread if the poll function is.
class CancelToken {
 public:
  CancelToken() = default;  ///< never cancelled
  explicit CancelToken(std::function<bool()> poll) : poll_(std::move(poll)) {}

  bool Cancelled() const { return poll_ && poll_(); }
  /// OK, or a Cancelled error with reason CANCELLED.
  absl::Status Check() const;

 private:
  std::function<bool()> poll_;
};

}  // namespace slicefarm
