#pragma once

#include <functional>
#include <utility>

#include "absl/status/status.h"

namespace slicefarm {

/// Token that reports whether the work has been cancelled. Algorithms that can take over 50 ms poll
/// the token and return its Cancelled error. Copies are cheap. A token may be polled from any
/// thread if its poll function allows this.
class CancelToken {
 public:
  CancelToken() = default;  ///< Makes a token that is never cancelled.
  explicit CancelToken(std::function<bool()> poll) : poll_(std::move(poll)) {}

  bool Cancelled() const { return poll_ && poll_(); }
  /// Returns OK, or a Cancelled error with reason CANCELLED.
  absl::Status Check() const;

 private:
  std::function<bool()> poll_;
};

}  // namespace slicefarm
