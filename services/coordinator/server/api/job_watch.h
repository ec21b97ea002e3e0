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
#include "services/coordinator/server/api/tenant_places.h"
#include "services/coordinator/server/api/watch_reads.h"
#include "services/coordinator/server/execution/job_feed.h"
#include "slicefarm/v1/jobs.grpc.pb.h"

namespace slicefarm::coordinator {

/// Largest number of watches at once. Each uses some memory, but threads only when an event occurs.
struct WatchOptions {
  int calls = 10'000;  ///< shared by the rule of TenantPlaces
};

/// Caller that watches, with its slot among the watchers.
struct Watcher {
  Caller caller;
  TenantPlaces::Place place;
};

/// Objects that watches use. All of them must outlive the watches.
struct JobWatches {
  /// Raw method, so that an unreadable request gets an error of this service with a reason.
  using Service = v1::Jobs::WithRawMethod_WatchJob<v1::Jobs::Service>;

  Service& service;
  grpc::ServerCompletionQueue& queue;
  WatchReads& reads;
  JobFeed& feed;
  /// Authenticates the caller and takes a slot for it.
  std::function<absl::StatusOr<Watcher>(const grpc::ServerContext& context)> admit;
};

/// One WatchJob call. Sends the job's events from the store, then the events that the feed
/// announces, and between them the progress of the run. Ends after the terminal event. Occupies no
/// thread while nothing happens, so that a thousand clients may watch. All functions except Wake
/// and Found run on the queue's thread and never block. Deletes itself.
class JobWatch {
 public:
  /// Waits for the next call. When the call comes, a new object waits for the call after it.
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
  std::atomic<bool> waking_ = false;  ///< true if woken_tag_ is one of them
  std::atomic<bool> news_ = false;    ///< true if the store has new events
  grpc::Alarm alarm_;                 ///< moves news of the feed to the queue's thread
  grpc::Alarm found_alarm_;           ///< moves the result of a read to the queue's thread

  int64_t ticket_ = 0;      ///< ticket of the feed
  int64_t read_to_ = 0;     ///< sequence of the last event that was read
  bool opened_ = false;     ///< true if the client was notified that the watch is open
  bool terminal_ = false;   ///< true if the event at read_to_ was the job's last
  bool wants_more_ = true;  ///< true if there may be events that the last read did not contain
  bool moved_ = false;      ///< true if the run may have progressed
  bool reading_ = false;    ///< true while a read is in progress
  bool busy_ = false;       ///< true while a message is being sent
  bool left_ = false;       ///< true if the call is over
  /// Result of the last read, shared by all watchers of the job.
  WatchReads::Result found_ = nullptr;
  std::shared_ptr<const JobSteps> steps_;  ///< events that are being sent
  size_t sent_ = 0;                        ///< number of these events that were sent
  std::shared_ptr<const JobSteps> last_;   ///< result of the last read
  std::optional<JobProgress> told_;        ///< progress that was sent last
};

}  // namespace slicefarm::coordinator
