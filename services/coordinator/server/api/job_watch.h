#pragma once

#include <grpcpp/alarm.h>
#include <grpcpp/grpcpp.h>

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

#include "absl/status/statusor.h"
#include "common/rpc/server/admission.h"
#include "common/rpc/server/call_queue.h"
#include "services/coordinator/server/execution/job_feed.h"
#include "services/coordinator/store/jobs/job_store.h"
#include "slicefarm/v1/jobs.grpc.pb.h"

namespace slicefarm::coordinator {

/// How many watches there may be at once: each takes some memory, and threads only when something
/// happens.
struct WatchOptions {
  int calls = 10'000;  ///< where there is one tenant only
  int calls_a_tenant = 5'000;
};

/// What watches need; everything outlives them.
struct JobWatches {
  /// Raw, so that a request that cannot be read gets its error from us, with a reason.
  using Service = v1::Jobs::WithRawMethod_WatchJob<v1::Jobs::Service>;

  Service& service;
  grpc::ServerCompletionQueue& queue;
  JobStore& jobs;
  JobFeed& feed;
  /// A place, if the caller may know of the job.
  std::function<absl::StatusOr<rpc::Admission::Ticket>(const grpc::ServerContext& context,
                                                       const v1::WatchJobRequest& request)>
      admit;
};

/// One WatchJob call: sends the job's events from the store, then those that the feed announces,
/// and ends after the terminal one. Holds no thread while nothing happens, so that a thousand may
/// watch. All but Wake happens on the queue's thread. Deletes itself.
class JobWatch {
 public:
  /// Waits for the next call; when it comes, another one waits for the one after.
  static void Await(const JobWatches& watches) { new JobWatch(watches); }

 private:
  explicit JobWatch(const JobWatches& watches);

  void Begin(bool ok);
  absl::Status Enter();
  void Sent(bool ok);
  void Woken();
  void Left();

  void Wake();
  void Advance();
  absl::Status Read();
  void Send();
  void End(const absl::Status& status);
  void Release();

  const JobWatches& watches_;
  grpc::ServerContext context_;
  grpc::ByteBuffer request_bytes_;
  v1::WatchJobRequest request_;
  grpc::ServerAsyncWriter<grpc::ByteBuffer> writer_{&context_};
  std::optional<rpc::Admission::Ticket> place_;

  rpc::QueueTag begun_tag_ = [this](bool ok) { Begin(ok); };
  rpc::QueueTag sent_tag_ = [this](bool ok) { Sent(ok); };
  rpc::QueueTag woken_tag_ = [this](bool) { Woken(); };
  rpc::QueueTag ended_tag_ = [this](bool) { Release(); };
  rpc::QueueTag left_tag_ = [this](bool) { Left(); };
  std::atomic<int> tags_ = 1;         ///< that the queue has still to call
  std::atomic<bool> waking_ = false;  ///< woken_tag_ is one of them
  grpc::Alarm alarm_;                 ///< by which the feed gets onto the queue's thread

  int64_t ticket_ = 0;                 ///< of the feed
  int64_t read_to_ = 0;                ///< sequence of the last event that was read
  bool terminal_ = false;              ///< that event was the job's last
  bool busy_ = false;                  ///< something is being sent
  bool left_ = false;                  ///< the call is over
  std::optional<JobRecord> job_;       ///< of which the events are
  std::deque<JobEventRecord> events_;  ///< to be sent; as messages they would be larger by far
};

}  // namespace slicefarm::coordinator
