#pragma once

#include <chrono>

#include "absl/status/status.h"
#include "common/base/cancel_token.h"

namespace slicefarm::rpc {

/// How often who waits asks whether it is still wanted.
constexpr std::chrono::milliseconds kPollCancel{20};

/// After how long the server that gave this error wants to be asked again; 0 if it does not say.
std::chrono::milliseconds RetryAfter(const absl::Status& error);

/// Waits for `time`. Errors: Cancelled as soon as nobody wants what comes after.
absl::Status AwaitRetry(std::chrono::milliseconds time, const CancelToken& cancel);

}  // namespace slicefarm::rpc
