#include "common/rpc/server/call_scope.h"

#include <algorithm>

#include "common/base/error.h"

namespace slicefarm::rpc {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kLookEvery{1};

CallScope::Clock::time_point DeadlineOf(const grpc::ServerContext& context,
                                        milliseconds default_deadline, milliseconds longest) {
  const auto left = HasDeadline(context)
                        ? std::chrono::duration_cast<milliseconds>(context.deadline() -
                                                                   std::chrono::system_clock::now())
                        : default_deadline;
  return CallScope::Clock::now() + std::min(left, longest);
}

}  // namespace

bool HasDeadline(const grpc::ServerContext& context) {
  constexpr std::chrono::hours kFar{24 * 365};  // less than gRPC's infinite deadline
  return context.deadline() - std::chrono::system_clock::now() <= kFar;
}

CallScope::CallScope(const grpc::ServerContext& context, milliseconds default_deadline,
                     milliseconds longest)
    : context_(context), deadline_(DeadlineOf(context, default_deadline, longest)) {}

CancelToken CallScope::Token() const {
  return CancelToken([this] { return Cancelled(); });
}

bool CallScope::Cancelled() const {
  if (cancelled_.load(std::memory_order_relaxed)) return true;
  const Clock::time_point now = Clock::now();
  if (now.time_since_epoch().count() < next_look_.load(std::memory_order_relaxed)) return false;
  const std::unique_lock lock(looking_, std::try_to_lock);
  if (!lock.owns_lock()) return false;
  next_look_.store((now + kLookEvery).time_since_epoch().count(), std::memory_order_relaxed);
  if (now >= deadline_ || context_.IsCancelled()) cancelled_.store(true);
  return cancelled_.load();
}

absl::Status CallScope::Outcome(absl::Status status) const {
  if (!absl::IsCancelled(status) || !Expired()) return status;
  return MakeError(absl::StatusCode::kDeadlineExceeded, Reason::kDeadlineExceeded,
                   "the call's deadline passed before the work was done");
}

}  // namespace slicefarm::rpc
