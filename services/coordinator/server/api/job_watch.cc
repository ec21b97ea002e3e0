#include "services/coordinator/server/api/job_watch.h"

#include <utility>

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"
#include "common/wire/support/wire_error.h"
#include "services/coordinator/server/api/jobs_wire.h"

namespace slicefarm::coordinator {
namespace {

constexpr int32_t kReadEvents = 100;

absl::Status Stopping() {
  return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                   "the coordinator stops; watch again from the last sequence",
                   {{rpc::kRetryAfterMs, "1000"}});
}

}  // namespace

JobWatch::JobWatch(const JobWatches& watches) : watches_(watches) {
  context_.AsyncNotifyWhenDone(&left_tag_);
  watches_.service.RequestWatchJob(&context_, &request_bytes_, &writer_, &watches_.queue,
                                   &watches_.queue, &begun_tag_);
}

/// There is a call; or there will be none, because the server stops.
void JobWatch::Begin(bool ok) {
  if (!ok) return Release();
  Await(watches_);
  ++tags_;  // left_tag_, which gRPC calls only of calls that began
  if (const absl::Status entered = Enter(); !entered.ok()) {
    End(entered);
    return Release();
  }
  read_to_ = request_.after_sequence();
  ticket_ = watches_.feed.Listen(request_.id(), [this] { Wake(); });
  // A client cannot tell a quiet job from a server that is gone: this says that the watch stands.
  context_.AddInitialMetadata("slicefarm-watch", "open");
  busy_ = true;
  ++tags_;
  writer_.SendInitialMetadata(&sent_tag_);
  Release();
}

absl::Status JobWatch::Enter() {
  if (watches_.feed.closed()) return Stopping();
  const auto read =
      grpc::SerializationTraits<v1::WatchJobRequest>::Deserialize(&request_bytes_, &request_);
  if (!read.ok()) return Malformed("request", "cannot be read");
  auto place = watches_.admit(context_, request_);
  if (place.ok()) place_.emplace(*std::move(place));
  return place.status();
}

/// The feed has something new. On any thread.
void JobWatch::Wake() {
  if (waking_.exchange(true)) return;
  ++tags_;
  alarm_.Set(&watches_.queue, gpr_now(GPR_CLOCK_MONOTONIC), &woken_tag_);
}

void JobWatch::Woken() {
  waking_ = false;
  Advance();
  Release();
}

void JobWatch::Sent(bool ok) {
  busy_ = !ok;  // if it could not be sent, nothing more can, and the call is soon over
  Advance();
  Release();
}

/// The client has all it is to get, or wants no more.
void JobWatch::Left() {
  left_ = true;
  place_.reset();
  watches_.feed.Forget(ticket_);
  Release();
}

/// Sends the next event, ends the call, or waits for the feed.
void JobWatch::Advance() {
  if (busy_ || left_) return;
  // Before the store is asked, which may be why the coordinator stops.
  if (events_.empty() && !terminal_ && watches_.feed.closed()) return End(Stopping());
  if (events_.empty() && !terminal_) {
    if (const absl::Status read = Read(); !read.ok()) return End(read);
  }
  if (!events_.empty()) return Send();
  if (terminal_) End(absl::OkStatus());
}

/// Fetches events from the store, and whether they are the last.
absl::Status JobWatch::Read() {
  const auto events = watches_.jobs.Events(request_.id(), read_to_, kReadEvents);
  if (!events.ok()) return events.status();
  auto job = watches_.jobs.Get(request_.id());
  if (!job.ok()) return job.status();
  events_.assign(events->begin(), events->end());
  if (!events_.empty()) read_to_ = events_.back().sequence;
  // The job may have gone on between the two reads: its end is reached with its last event. A
  // watcher that starts after that has nothing to wait for.
  terminal_ = IsTerminal(job->state) && read_to_ >= job->last_sequence;
  job->spec.clear();  // events do without
  if (!events_.empty()) job_ = *std::move(job);
  return absl::OkStatus();
}

void JobWatch::Send() {
  grpc::ByteBuffer bytes;
  bool own = false;
  const grpc::Status written = grpc::SerializationTraits<v1::JobEvent>::Serialize(
      ToProto(events_.front(), *job_), &bytes, &own);
  if (!written.ok()) return End(absl::InternalError(written.error_message()));
  events_.pop_front();
  if (events_.empty()) job_.reset();
  busy_ = true;
  ++tags_;
  writer_.Write(bytes, &sent_tag_);
}

void JobWatch::End(const absl::Status& status) {
  busy_ = true;  // for good
  place_.reset();
  ++tags_;
  writer_.Finish(rpc::ToGrpc(status), &ended_tag_);
}

/// One of the tags was called. The last one takes the watch with it.
void JobWatch::Release() {
  if (--tags_ == 0) delete this;
}

}  // namespace slicefarm::coordinator
