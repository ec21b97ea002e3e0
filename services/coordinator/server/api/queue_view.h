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

/// Where waiting jobs stand in the farm's queue, and when jobs will have ended. Thread-safe.
///
/// One look at the queue serves all calls for 20 times as long as it took, so that looks take a
/// twentieth of a core at most, however many calls ask and however long the queue is.
class QueueView {
 public:
  /// `jobs` outlives it.
  QueueView(JobStore& jobs, std::function<int64_t()> now_us);

  /// Adds place and expected end to an answer about this job. Adds nothing where they cannot be
  /// known: to jobs that wait for their next attempt or for the same work, and while the store does
  /// not answer within half a second.
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
