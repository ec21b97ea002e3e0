#include "services/coordinator/server/api/tenant_watch.h"

#include "services/coordinator/server/api/watch_reads.h"
#include "services/coordinator/server/messages/jobs_wire.h"

namespace slicefarm::coordinator {
namespace {

/// Shortest interval between reads of the store, for any number of events.
constexpr std::chrono::milliseconds kPause{100};
/// Longest interval between reads of the store. The watch also checks at this interval whether the
/// client has left.
constexpr std::chrono::milliseconds kLookEvery{1'000};
constexpr int64_t kSignOfLifeUs = 15'000'000;

absl::Status ClientLeft() { return absl::CancelledError("the client has left"); }

}  // namespace

TenantWatch::TenantWatch(JobStore& jobs, JobFeed& feed, const std::function<int64_t()>& now_us)
    : jobs_(jobs), feed_(feed), now_us_(now_us) {
  ticket_ = feed_.ListenToAll([this](JobFeed::News) {
    const std::lock_guard lock(mutex_);
    news_ = true;
    changed_.notify_all();
  });
}

void TenantWatch::AwaitNews() {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, kPause, [&] { return feed_.closed(); });
  changed_.wait_for(lock, kLookEvery - kPause, [&] { return news_ || feed_.closed(); });
  news_ = false;
}

/// Sends the events. Skips the events of jobs that were deleted meanwhile.
absl::Status TenantWatch::Send(const TenantEvents& events, const std::vector<TenantEvent>& found,
                               Writer& writer) {
  v1::WatchJobsResponse response;
  response.set_cursor(events.cursor());
  for (const TenantEvent& event : found) {
    const auto job = jobs_.GetWithoutSpec(event.job_id);
    if (absl::IsNotFound(job.status())) continue;
    if (!job.ok()) return job.status();
    *response.mutable_event() = ToProto(event.event, *job);
    if (!writer.Write(response)) return ClientLeft();
  }
  return absl::OkStatus();
}

absl::Status TenantWatch::Run(TenantEvents events, const grpc::ServerContext& context,
                              Writer& writer) {
  int64_t sent_us = 0;
  while (!context.IsCancelled()) {
    if (feed_.closed()) return CoordinatorStops();
    const int64_t now_us = now_us_();
    const auto found = events.Next(now_us);
    if (!found.ok()) return found.status();
    if (absl::Status sent = Send(events, *found, writer); !sent.ok()) return sent;
    if (!found->empty()) sent_us = now_us;
    if (now_us - sent_us >= kSignOfLifeUs) {
      v1::WatchJobsResponse alive;
      alive.set_cursor(events.cursor());
      if (!writer.Write(alive)) return ClientLeft();
      sent_us = now_us;
    }
    if (!events.more()) AwaitNews();
  }
  return ClientLeft();
}

}  // namespace slicefarm::coordinator
