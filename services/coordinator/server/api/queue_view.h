#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>

#include "common/base/stopwatch.h"
#include "services/coordinator/server/observe/patient_look.h"
#include "services/coordinator/store/jobs/job_store.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

/// Positions of waiting jobs in the farm's queue, and expected ends of jobs. Thread-safe.
///
/// One snapshot of the queue is used for a period of 20 times the duration of its read. So the
/// reads of snapshots use at most a twentieth of a core, for any number of calls and any length of
/// the queue.
class QueueView {
 public:
  /// Creates a view of the queue in `jobs`, which must outlive it.
  QueueView(JobStore& jobs, std::function<int64_t()> now_us);

  /// Adds the position in the queue and the expected end of `job` to `answer`. Adds nothing if they
  /// are unknown: for a job that waits for its next attempt or for another job with the same work,
  /// and if the store does not answer within half a second.
  void Describe(const JobRecord& job, v1::Job& answer);

 private:
  struct Look;

  std::shared_ptr<const Look> Latest();
  void DescribeQueued(const JobRecord& job, v1::Job& answer);
  void DescribeRunning(const JobRecord& job, v1::Job& answer);

  const std::function<int64_t()> now_us_;
  std::mutex mutex_;
  std::shared_ptr<const Look> latest_;
  PatientLook<std::shared_ptr<const Look>> look_;
};

}  // namespace slicefarm::coordinator
