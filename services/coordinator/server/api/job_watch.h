#pragma once

#include <grpcpp/alarm.h>
#include <grpcpp/grpcpp.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "absl/status/statusor.h"
#include "common/rpc/server/call_queue.h"
#include "services/coordinator/server/api/callers.h"
#include "services/coordinator/server/api/tenant_slots.h"
#include "services/coordinator/server/api/watch_reads.h"
#include "services/coordinator/server/execution/job_feed.h"
#include "slicefarm/v1/jobs.grpc.pb.h"

namespace slicefarm::coordinator {

/// Largest number of watches at once. Each watch uses some memory, and a thread only while it
/// processes an event.
struct WatchOptions {
  int calls = 10'000;  ///< number of slots, which tenants share by the rule of TenantSlots
};

/// Caller that watches, with its slot among the watchers.
struct Watcher {
  Caller caller;
  TenantSlots::Slot slot;
};

/// Objects that watches use. All of them must outlive the watches.
struct JobWatches {
  /// Raw method: this class parses the request itself, so that an unreadable request gets an error
  /// with a reason of this service.
  using Service = v1::Jobs::WithRawMethod_WatchJob<v1::Jobs::Service>;

  Service& service;
  grpc::ServerCompletionQueue& queue;
  WatchReads& reads;
  JobFeed& feed;
  /// Authenticates the caller and takes a slot for the watch.
  std::function<absl::StatusOr<Watcher>(const grpc::ServerContext& context)> admit;
};

/// One WatchJob call. First sends the job's events from the store, then each new event when the
/// feed announces it, and between them the progress of the run. Ends after the job's last event.
/// Occupies no thread while nothing happens, so that a thousand clients may watch. All functions
/// except Wake and Found run on the queue's thread and never block. Deletes itself.
class JobWatch {
 public:
  /// Waits for the next WatchJob call. When it comes, a new object begins to wait for the following
  /// call.
  static void Await(const JobWatches& watches) { new JobWatch(watches); }

 private:
  explicit JobWatch(const JobWatches& watches);

  void Begin(bool ok);
  absl::Status Enter();
  void Opened();
  void Sent(bool ok);
  void Woken();
  void Left();

  void Wake(JobFeed::News news);
  void Advance();
  void Read();
  void Found(WatchReads::Result found);
  void Take();
  absl::Status Check();
  void Send();
  void SendProgress();
  void Write(const JobEventRecord& event, const JobRecord& job);
  void End(const absl::Status& status);
  void Release();

  const JobWatches& watches_;
  grpc::ServerContext context_;
  grpc::ByteBuffer request_bytes_;
  v1::WatchJobRequest request_;
  grpc::ServerAsyncWriter<grpc::ByteBuffer> writer_{&context_};
  std::optional<Watcher> watcher_;

  rpc::QueueTag begun_tag_ = [this](bool ok) { Begin(ok); };
  rpc::QueueTag sent_tag_ = [this](bool ok) { Sent(ok); };
  rpc::QueueTag woken_tag_ = [this](bool) { Woken(); };
  rpc::QueueTag found_tag_ = [this](bool) { Take(); };
  rpc::QueueTag ended_tag_ = [this](bool) { Release(); };
  rpc::QueueTag left_tag_ = [this](bool) { Left(); };
  std::atomic<int> tags_ = 1;         ///< number of tags that the queue still has to call
  std::atomic<bool> waking_ = false;  ///< true if the queue still has to call woken_tag_
  std::atomic<bool> news_ = false;    ///< true if the store has new events
  grpc::Alarm alarm_;  ///< calls woken_tag_ on the queue's thread after a notification of the feed
  grpc::Alarm found_alarm_;  ///< calls found_tag_ on the queue's thread after a read

  int64_t ticket_ = 0;      ///< ticket that JobFeed::Listen returned for this watch
  int64_t read_to_ = 0;     ///< sequence of the last event that was read
  bool opened_ = false;     ///< true if the client was notified that the watch is open
  bool terminal_ = false;   ///< true if the event `read_to_` is the job's last
  bool wants_more_ = true;  ///< true if the store may have events after `read_to_`
  bool moved_ = false;      ///< true if the run may have progressed
  bool reading_ = false;    ///< true while a read is in progress
  bool busy_ = false;       ///< true while a message is being sent
  bool left_ = false;       ///< true if the call is over
  /// Result of the last read, from the time when Found receives it until Take has processed it. All
  /// watchers of the job share the result.
  WatchReads::Result found_ = nullptr;
  /// result of a read, with the events that are being sent
  std::shared_ptr<const JobSteps> steps_;
  size_t sent_ = 0;                       ///< number of events of `steps_` that were sent
  std::shared_ptr<const JobSteps> last_;  ///< last result of a read that was processed
  std::optional<JobProgress> reported_;   ///< progress that was sent last
};

}  // namespace slicefarm::coordinator
