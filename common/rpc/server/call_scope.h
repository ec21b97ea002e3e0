#pragma once

#include <grpcpp/server_context.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>

#include "absl/status/status.h"
#include "common/base/cancel_token.h"

namespace slicefarm::rpc {

/// Whether the client of the call set a deadline.
bool HasDeadline(const grpc::ServerContext& context);

/// Until when a call is worth working on, and whether its caller still waits: what a handler hands
/// on to the algorithm. Lives as long as the handler runs. Thread-safe.
class CallScope {
 public:
  using Clock = std::chrono::steady_clock;

  static constexpr std::chrono::milliseconds kNoLimit = std::chrono::milliseconds::max();

  /// `default_deadline` holds where the client sent none; `longest` also where it sent one.
  CallScope(const grpc::ServerContext& context, std::chrono::milliseconds default_deadline,
            std::chrono::milliseconds longest = kNoLimit);

  /// Cancelled when the client went away or gave up, the deadline passed, or the server stops.
  /// Cheap to poll: it asks gRPC once in a millisecond. Must not outlive the scope.
  CancelToken Token() const;
  bool Cancelled() const;

  /// The status to answer with: where the work ended as Cancelled because time was up,
  /// DeadlineExceeded.
  absl::Status Outcome(absl::Status status) const;

 private:
  bool Expired() const { return Clock::now() >= deadline_; }

  const grpc::ServerContext& context_;
  const Clock::time_point deadline_;
  mutable std::atomic<bool> cancelled_ = false;
  mutable std::atomic<Clock::rep> next_look_ = 0;
  mutable std::mutex looking_;  // gRPC lets only a few threads ask at a time
};

}  // namespace slicefarm::rpc
