#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "common/rpc/json_log.h"
#include "common/stage/stopwatch.h"
#include "services/coordinator/algo/job_pipeline.h"
#include "services/coordinator/server/job_feed.h"
#include "services/coordinator/server/job_request.h"
#include "services/coordinator/server/job_results.h"

namespace slicefarm::coordinator {

/// What all runs share. Everything outlives the runs.
struct RunEnvironment {
  JobStore& jobs;
  BlobStores& blobs;
  JobResults& results;
  const JobPipeline& pipeline;
  JobFeed& feed;
  std::function<int64_t()> now_us;
  std::string build_id;
  ResultSharing sharing = ResultSharing::kOff;
  rpc::JsonLog log;
};

/// One claimed job, from the claim to what it came to:
///   1 the cache   2 RUNNING   3 meshes from the blob store   4 pipeline   5 artifacts and record
/// It ends as SUCCEEDED, FAILED or CANCELLED; or goes back to QUEUED: when the coordinator stops,
/// when services are not there (five times, ever later), when the disk is full, when a store fails
/// (ever later, without end). If that cannot be written, the lease runs out and the job is claimed
/// again. After a fencing nothing is written any more.
class JobRun {
 public:
  JobRun(RunEnvironment& environment, JobRecord job);

  void Run();

  // From any thread.
  void Cancel() { cancelled_ = true; }      ///< its client wants it to end
  void HandBack() { handed_back_ = true; }  ///< the coordinator stops
  void Lose() { lost_ = true; }             ///< it may have been claimed again

  const Lease& lease() const { return lease_; }
  const std::string& action_digest() const { return job_.action_digest; }
  bool lost() const { return lost_; }

 private:
  absl::Status Work();
  absl::Status Compute(ResolvedJob job);
  absl::StatusOr<SliceInput> LoadMeshes(const JobRequest& request);
  void Progress(PipelineProgress progress);
  void Conclude(const absl::Status& status);
  JobUpdate Conclusion(const absl::Status& status) const;
  absl::Status Write(const JobUpdate& update);
  absl::Status Written(const absl::Status& status);
  bool GivenUp() const { return cancelled_ || handed_back_ || lost_ || Overdue(); }
  bool Overdue() const { return environment_.now_us() >= job_.deadline_us; }

  RunEnvironment& environment_;
  const JobRecord job_;
  const std::string result_tenant_;
  const Lease lease_;
  std::atomic<bool> cancelled_ = false;
  std::atomic<bool> handed_back_ = false;
  std::atomic<bool> lost_ = false;
  PipelineProgress told_;
  Stopwatch clock_;
  double told_at_s_ = 0;
};

}  // namespace slicefarm::coordinator
