#pragma once

#include <grpcpp/support/server_callback.h>

#include <deque>
#include <mutex>
#include <string>

#include "services/coordinator/server/job_feed.h"
#include "services/coordinator/store/job_store.h"
#include "slicefarm/v1/jobs.grpc.pb.h"

namespace slicefarm::coordinator {

/// One WatchJob call: sends the job's events from the store, then those that the feed announces,
/// and ends after the terminal one. Holds no thread while nothing happens, so that a thousand may
/// watch. Deletes itself.
class JobWatch final : public grpc::ServerWriteReactor<v1::JobEvent> {
 public:
  JobWatch(grpc::CallbackServerContext& context, JobStore& jobs, JobFeed& feed, std::string job_id,
           int64_t after_sequence);

  void OnWriteDone(bool ok) override;
  void OnCancel() override;
  void OnDone() override;

 private:
  void Wake();
  void Advance();
  bool Read(absl::Status& status);

  JobStore& jobs_;
  JobFeed& feed_;
  const std::string job_id_;
  int64_t ticket_ = 0;

  std::mutex mutex_;
  int64_t sent_ = 0;       ///< sequence of the last event that was read
  bool terminal_ = false;  ///< that event was the job's last
  bool busy_ = true;       ///< a write is under way, or somebody decides what comes next
  bool news_ = false;      ///< the feed called meanwhile
  bool cancelled_ = false;
  std::deque<v1::JobEvent> events_;  ///< to be sent; the first one is being sent
};

}  // namespace slicefarm::coordinator
