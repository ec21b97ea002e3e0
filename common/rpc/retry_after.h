#pragma once

#include <chrono>

#include "absl/status/status.h"
#include "common/base/cancel_token.h"

namespace slicefarm::rpc {

/// Interval at which waiting code polls its cancel token.
constexpr std::chrono::milliseconds kPollCancel{20};

/// Returns the time after which a call that failed with this error may be retried. Returns 0 if the
/// error does not contain a time (kRetryAfterMs).
std::chrono::milliseconds RetryAfter(const absl::Status& error);

/// Waits for `time`. Errors: Cancelled as soon as `cancel` is cancelled.
absl::Status AwaitRetry(std::chrono::milliseconds time, const CancelToken& cancel);

}  // namespace slicefarm::rpc
