#include "services/coordinator/server/job_watch.h"

#include <optional>
#include <utility>

#include "common/model/error.h"
#include "common/rpc/status_mapping.h"
#include "services/coordinator/server/jobs_wire.h"

namespace slicefarm::coordinator {
namespace {

constexpr int32_t kReadEvents = 100;

absl::Status Stopping() {
  return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                   "the coordinator stops; watch again from the last sequence",
                   {{rpc::kRetryAfterMs, "1000"}});
}

}  // namespace

JobWatch::JobWatch(grpc::CallbackServerContext& context, JobStore& jobs, JobFeed& feed,
                   std::string job_id, int64_t after_sequence)
    : jobs_(jobs), feed_(feed), job_id_(std::move(job_id)), sent_(after_sequence) {
  // A client cannot tell a quiet job from a server that is gone: this says that the watch stands.
  context.AddInitialMetadata("slicefarm-watch", "open");
  StartSendInitialMetadata();
  ticket_ = feed_.Listen(job_id_, [this] { Wake(); });
  Advance();
}

/// The feed has something new. REQUIRES: no lock held.
void JobWatch::Wake() {
  {
    std::lock_guard lock(mutex_);
    news_ = true;
    if (busy_) return;
    busy_ = true;
  }
  Advance();
}

/// Sends the next event, ends the call, or goes idle. REQUIRES: busy_ was set by the caller.
void JobWatch::Advance() {
  std::unique_lock lock(mutex_);
  std::optional<absl::Status> end;
  while (!end && events_.empty()) {
    if (cancelled_) end = absl::CancelledError("the client left");
    if (!end && terminal_) end = absl::OkStatus();
    if (!end && feed_.closed()) end = Stopping();
    if (end) break;
    news_ = false;
    lock.unlock();
    absl::Status status;
    const bool found = Read(status);
    lock.lock();
    if (!status.ok()) end = status;
    if (end || found || news_) continue;
    busy_ = false;
    return;
  }
  lock.unlock();
  if (end) return Finish(rpc::ToGrpc(*end));  // busy_ stays: nothing happens any more
  StartWrite(&events_.front());
}

/// Fetches events from the store. True if there are some, or the job's end was reached.
bool JobWatch::Read(absl::Status& status) {
  const auto events = jobs_.Events(job_id_, sent_, kReadEvents);
  const auto job = jobs_.Get(job_id_);
  status = events.ok() ? job.status() : events.status();
  if (!status.ok()) return false;
  for (const JobEventRecord& event : *events) {
    events_.push_back(ToProto(event, *job));
    sent_ = event.sequence;
  }
  // The job may have gone on between the two reads: its end is reached with its last event. A
  // watcher that starts after that has nothing to wait for.
  terminal_ = IsTerminal(job->state) && sent_ >= job->last_sequence;
  return !events->empty() || terminal_;
}

void JobWatch::OnWriteDone(bool ok) {
  {
    std::lock_guard lock(mutex_);
    events_.pop_front();
    if (!ok) cancelled_ = true;
    if (cancelled_) events_.clear();
  }
  Advance();
}

void JobWatch::OnCancel() {
  {
    std::lock_guard lock(mutex_);
    cancelled_ = true;
  }
  Wake();
}

void JobWatch::OnDone() {
  feed_.Forget(ticket_);
  delete this;
}

}  // namespace slicefarm::coordinator
