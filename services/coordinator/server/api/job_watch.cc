#include "services/coordinator/server/api/job_watch.h"

#include <utility>

#include "common/rpc/status_mapping.h"
#include "common/wire/support/wire_error.h"
#include "services/coordinator/server/messages/jobs_wire.h"
#include "services/coordinator/store/jobs/job_steps.h"

namespace slicefarm::coordinator {

JobWatch::JobWatch(const JobWatches& watches) : watches_(watches) {
  context_.AsyncNotifyWhenDone(&left_tag_);
  watches_.service.RequestWatchJob(&context_, &request_bytes_, &writer_, &watches_.queue,
                                   &watches_.queue, &begun_tag_);
}

/// Begins a call. If `ok` is false, no call has come, because the server stops.
void JobWatch::Begin(bool ok) {
  if (!ok) return Release();
  Await(watches_);
  ++tags_;  // counts left_tag_, which gRPC calls only for calls that began
  if (const absl::Status entered = Enter(); !entered.ok()) {
    End(entered);
    return Release();
  }
  read_to_ = request_.after_sequence();
  ticket_ = watches_.feed.Listen(request_.id(), [this](JobFeed::News news) { Wake(news); });
  Advance();
  Release();
}

absl::Status JobWatch::Enter() {
  if (watches_.feed.closed()) return CoordinatorStops();
  const auto read =
      grpc::SerializationTraits<v1::WatchJobRequest>::Deserialize(&request_bytes_, &request_);
  if (!read.ok()) return Malformed("request", "cannot be read");
  auto watcher = watches_.admit(context_);
  if (watcher.ok()) watcher_.emplace(*std::move(watcher));
  return watcher.status();
}

/// Reports that the watch is open. Otherwise a client could not distinguish a quiet job from a dead
/// server.
void JobWatch::Opened() {
  opened_ = true;
  context_.AddInitialMetadata("slicefarm-watch", "open");
  busy_ = true;
  ++tags_;
  writer_.SendInitialMetadata(&sent_tag_);
}

/// Notifies the watch about news of the feed. May be called on any thread.
void JobWatch::Wake(JobFeed::News news) {
  if (news == JobFeed::News::kEvents) news_ = true;
  if (waking_.exchange(true)) return;
  ++tags_;
  alarm_.Set(&watches_.queue, gpr_now(GPR_CLOCK_MONOTONIC), &woken_tag_);
}

void JobWatch::Woken() {
  waking_ = false;
  if (news_.exchange(false)) wants_more_ = true;
  moved_ = true;
  Advance();
  Release();
}

void JobWatch::Sent(bool ok) {
  busy_ = !ok;  // after a failed send, nothing more can be sent, and the call ends soon
  Advance();
  Release();
}

/// Ends the watch after the call has ended or the client has left.
void JobWatch::Left() {
  left_ = true;
  watcher_.reset();
  watches_.feed.Forget(ticket_);
  Release();
}

/// Takes the next step: sends the next event, ends the call, reads from the store, sends the
/// progress of the run, or waits for the feed.
void JobWatch::Advance() {
  if (busy_ || left_ || reading_) return;
  // This check comes before the read, because the store may be the reason that the coordinator
  // stops.
  if (!steps_ && !terminal_ && watches_.feed.closed()) return End(CoordinatorStops());
  if (steps_) return Send();
  if (terminal_) return End(absl::OkStatus());
  if (wants_more_) return Read();
  if (moved_) SendProgress();
}

void JobWatch::Read() {
  wants_more_ = false;  // later events wake the watch
  reading_ = true;
  ++tags_;
  watches_.reads.Read(watcher_->caller.tenant, request_.id(), read_to_,
                      [this](WatchReads::Result found) { Found(std::move(found)); });
}

/// Takes the answer of the store. May be called on any thread.
void JobWatch::Found(WatchReads::Result found) {
  found_ = std::move(found);
  found_alarm_.Set(&watches_.queue, gpr_now(GPR_CLOCK_MONOTONIC), &found_tag_);
}

void JobWatch::Take() {
  reading_ = false;
  if (!left_) {
    if (const absl::Status seen = Check(); !seen.ok()) {
      End(seen);
    } else {
      if (!opened_) Opened();
      Advance();
    }
  }
  Release();
}

/// Takes the result of the read, if the caller may see the job.
absl::Status JobWatch::Check() {
  if (!found_.ok()) return found_.status();
  const std::shared_ptr<const JobSteps> found = *std::exchange(found_, nullptr);
  const Caller& caller = watcher_->caller;
  if (found->job.tenant != caller.tenant && !caller.may(Scope::kAdmin))
    return JobNotFound(request_.id());
  // A watcher that starts after the job's end has nothing to wait for.
  if (!found->events.empty()) read_to_ = found->events.back().sequence;
  terminal_ = found->EndsAt(read_to_);
  if (std::ssize(found->events) == WatchReads::kEventsAtOnce) wants_more_ = true;
  if (!found->events.empty()) steps_ = found;
  sent_ = 0;
  last_ = found;
  moved_ = true;
  return absl::OkStatus();
}

void JobWatch::Send() {
  const auto steps = steps_;
  const size_t next = sent_++;
  if (sent_ == steps->events.size()) steps_.reset();
  Write(steps->events[next], steps->job);
}

/// Sends the progress under the number of the last event. So a client that continues from this
/// number misses no event.
void JobWatch::SendProgress() {
  moved_ = false;
  const auto progress = watches_.feed.ProgressOf(request_.id());
  const JobRecord& job = last_->job;
  const bool of_run = progress && progress->epoch == job.owner_epoch;
  if (job.state != JobState::kRunning || !of_run || progress == reported_) return;
  reported_ = progress;
  Write({read_to_, progress->time_us, job.state, progress->layers_total, progress->layers_done},
        job);
}

void JobWatch::Write(const JobEventRecord& event, const JobRecord& job) {
  grpc::ByteBuffer bytes;
  bool own = false;
  const grpc::Status written =
      grpc::SerializationTraits<v1::JobEvent>::Serialize(ToProto(event, job), &bytes, &own);
  if (!written.ok()) return End(absl::InternalError(written.error_message()));
  busy_ = true;
  ++tags_;
  writer_.Write(bytes, &sent_tag_);
}

void JobWatch::End(const absl::Status& status) {
  busy_ = true;  // the call sends nothing more
  watcher_.reset();
  ++tags_;
  writer_.Finish(rpc::ToGrpc(status), &ended_tag_);
}

/// Counts a finished tag. The last one deletes the watch.
void JobWatch::Release() {
  if (--tags_ == 0) delete this;
}

}  // namespace slicefarm::coordinator
