#include "common/rpc/server/stream_watch.h"

#include <fmt/core.h>

#include <algorithm>

#include "common/base/error.h"
#include "common/rpc/server/call_scope.h"

namespace slicefarm::rpc {
namespace {

constexpr std::chrono::hours kFar{24 * 365};

}  // namespace

StreamWatch::StreamWatch(const StreamTimes& times) : times_(times), thread_([this] { Run(); }) {}

StreamWatch::~StreamWatch() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void StreamWatch::Run() {
  std::unique_lock lock(mutex_);
  while (!stopping_) changed_.wait_until(lock, CutWhatIsDue());
}

/// Cuts overdue streams and returns the time of the next check. Messages that arrive meanwhile only
/// delay the check. REQUIRES: mutex_ is held, so that no guarded call ends meanwhile.
StreamWatch::Clock::time_point StreamWatch::CutWhatIsDue() {
  const Clock::time_point now = Clock::now();
  Clock::time_point next = now + kFar;
  for (Entry& entry : entries_) {
    if (entry.cut) continue;
    const Clock::time_point due = std::min(entry.deadline, entry.due.load());
    if (due > now) {
      next = std::min(next, due);
      continue;
    }
    entry.cut = true;
    entry.context.TryCancel();  // reads and writes of the handler fail immediately
  }
  return next;
}

StreamWatch::Guard::Guard(StreamWatch& watch, grpc::ServerContext& context) : watch_(watch) {
  const Clock::time_point now = Clock::now();
  const Clock::time_point deadline = now +
                                     // gRPC enforces the client's deadline
                                     (HasDeadline(context) ? kFar : watch.times_.default_deadline);
  {
    const std::lock_guard lock(watch_.mutex_);
    entry_ =
        watch_.entries_.emplace(watch_.entries_.end(), context, deadline, now + watch_.times_.idle);
  }
  watch_.changed_.notify_one();
}

StreamWatch::Guard::~Guard() {
  const std::lock_guard lock(watch_.mutex_);
  watch_.entries_.erase(entry_);
}

void StreamWatch::Guard::Moved(int64_t bytes) {
  using Seconds = std::chrono::duration<double>;
  const Seconds earned(static_cast<double>(bytes) /
                       static_cast<double>(watch_.times_.min_bytes_per_s));
  const Clock::time_point latest = Clock::now() + watch_.times_.idle;
  entry_->due.store(
      std::min(latest, entry_->due.load() + std::chrono::duration_cast<Clock::duration>(earned)));
}

absl::Status StreamWatch::Guard::Outcome(absl::Status status) const {
  const std::lock_guard lock(watch_.mutex_);
  if (!entry_->cut) return status;
  return MakeError(absl::StatusCode::kDeadlineExceeded, Reason::kDeadlineExceeded,
                   fmt::format("less than {} bytes a second moved for {} ms, or the call had no "
                               "deadline and took more than {} ms",
                               watch_.times_.min_bytes_per_s, watch_.times_.idle.count(),
                               watch_.times_.default_deadline.count()));
}

}  // namespace slicefarm::rpc
