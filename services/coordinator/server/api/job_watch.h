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

/// How many watches there may be at once: each takes some memory, and threads only when something
/// happens.
struct WatchOptions {
  int calls = 10'000;  ///< shared as TenantPlaces says
};

/// Who watches, and his place among those who do.
struct Watcher {
  Caller caller;
  TenantPlaces::Place place;
};

/// What watches need; everything outlives them.
struct JobWatches {
  /// Raw, so that a request that cannot be read gets its error from us, with a reason.
  using Service = v1::Jobs::WithRawMethod_WatchJob<v1::Jobs::Service>;

  Service& service;
  grpc::ServerCompletionQueue& queue;
  WatchReads& reads;
  JobFeed& feed;
  /// Finds out who calls, and whether there is a place for him.
  std::function<absl::StatusOr<Watcher>(const grpc::ServerContext& context)> admit;
};

/// One WatchJob call: sends the job's events from the store, then those that the feed announces,
/// and between them how far its run has come; ends after the terminal one. Holds no thread while
/// nothing happens, so that a thousand may watch. All but Wake and Found happens on the queue's
/// thread, where nothing is waited for. Deletes itself.
class JobWatch {
 public:
  /// Waits for the next call; when it comes, another one waits for the one after.
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
  std::atomic<int> tags_ = 1;         ///< that the queue has still to call
  std::atomic<bool> waking_ = false;  ///< woken_tag_ is one of them
  std::atomic<bool> news_ = false;    ///< that are in the store
  grpc::Alarm alarm_;                 ///< by which the feed gets onto the queue's thread
  grpc::Alarm found_alarm_;           ///< by which what was read does

  int64_t ticket_ = 0;      ///< of the feed
  int64_t read_to_ = 0;     ///< sequence of the last event that was read
  bool opened_ = false;     ///< the client knows that the watch stands
  bool terminal_ = false;   ///< the event at read_to_ was the job's last
  bool wants_more_ = true;  ///< there may be events that were not there at the last read
  bool moved_ = false;      ///< the run may have come further
  bool reading_ = false;    ///< a read is under way
  bool busy_ = false;       ///< something is being sent
  bool left_ = false;       ///< the call is over
  WatchReads::Result found_ = nullptr;     ///< by the last read, shared by all who watch the job
  std::shared_ptr<const JobSteps> steps_;  ///< those that are being sent
  size_t sent_ = 0;                        ///< of these
  std::shared_ptr<const JobSteps> last_;   ///< what was read last
  std::optional<JobProgress> told_;        ///< how far the run had come when that was sent last
};

}  // namespace slicefarm::coordinator
