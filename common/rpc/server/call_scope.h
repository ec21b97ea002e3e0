#pragma once

#include <grpcpp/server_context.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>

#include "absl/status/status.h"
#include "common/base/cancel_token.h"

namespace slicefarm::rpc {

/// Returns true if the client of the call has set a deadline.
bool HasDeadline(const grpc::ServerContext& context);

/// Deadline and cancellation of a call on the server. The call's handler passes Token() to the
/// algorithm. The object must exist until the handler ends. Thread-safe.
class CallScope {
 public:
  using Clock = std::chrono::steady_clock;

  static constexpr std::chrono::milliseconds kNoLimit = std::chrono::milliseconds::max();

  /// Creates the scope of a call. `default_deadline`: used if the client has set no deadline.
  /// `longest`: time limit that applies even if the client has set a later deadline.
  CallScope(const grpc::ServerContext& context, std::chrono::milliseconds default_deadline,
            std::chrono::milliseconds longest = kNoLimit);

  /// Returns a token that is cancelled when the client disconnects or cancels, when the deadline
  /// passes, or when the server stops. The token is cheap to poll: it queries gRPC once per
  /// millisecond. It must not outlive the scope.
  CancelToken Token() const;
  /// Returns true if Token() is cancelled.
  bool Cancelled() const;

  /// Returns the status for the client: DeadlineExceeded if `status` is Cancelled because of the
  /// deadline, otherwise `status`.
  absl::Status Outcome(absl::Status status) const;

 private:
  bool Expired() const { return Clock::now() >= deadline_; }

  const grpc::ServerContext& context_;
  const Clock::time_point deadline_;
  mutable std::atomic<bool> cancelled_ = false;
  mutable std::atomic<Clock::rep> next_look_ = 0;
  mutable std::mutex looking_;  // gRPC allows only a few threads to query at the same time
};

}  // namespace slicefarm::rpc
