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
/// One snapshot of the queue serves all calls for 20 times as long as it took. So snapshots use at
/// most a twentieth of a core, for any number of calls and any length of the queue.
class QueueView {
 public:
  /// Creates a view of the queue in `jobs`, which must outlive it.
  QueueView(JobStore& jobs, std::function<int64_t()> now_us);

  /// Adds the position and the expected end to an answer about this job. Adds nothing if they are
  /// unknown: for jobs that wait for their next attempt or for the same work. Also adds nothing
  /// while the store does not answer within half a second.
  void Tell(const JobRecord& job, v1::Job& answer);

 private:
  struct Look;

  std::shared_ptr<const Look> Latest();
  void TellQueued(const JobRecord& job, v1::Job& answer);
  void TellRunning(const JobRecord& job, v1::Job& answer);

  const std::function<int64_t()> now_us_;
  std::mutex mutex_;
  std::shared_ptr<const Look> latest_;
  PatientLook<std::shared_ptr<const Look>> look_;
};

}  // namespace slicefarm::coordinator
