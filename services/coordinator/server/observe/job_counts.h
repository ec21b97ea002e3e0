#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "common/base/stopwatch.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// Number of jobs by state in a store. Open jobs are counted exactly. Ended jobs may be a million,
/// so their count may be up to a minute old. Thread-safe.
class JobCounts {
 public:
  /// Counts the jobs in `jobs`, which must outlive this object.
  explicit JobCounts(JobStore& jobs) : jobs_(jobs) {}

  /// Returns the number of jobs by state. `open`: current counts of the open jobs, from
  /// JobStore::CountOpen. Errors: see JobStore.
  absl::StatusOr<std::map<JobState, int64_t>> With(const std::vector<OpenJobs>& open);

 private:
  JobStore& jobs_;
  std::mutex mutex_;
  std::optional<Stopwatch> since_;  ///< time since the ended jobs were counted
  std::map<JobState, int64_t> ended_;
};

}  // namespace slicefarm::coordinator
