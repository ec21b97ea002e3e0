#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "common/base/stopwatch.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// How many jobs of each state a store has: those that are open as they are, and those that have
/// ended as they were at most a minute ago, as they may be a million. Thread-safe.
class JobCounts {
 public:
  /// `jobs` outlives it.
  explicit JobCounts(JobStore& jobs) : jobs_(jobs) {}

  /// With the open ones as JobStore::CountOpen has them. Errors: the store's.
  absl::StatusOr<std::map<JobState, int64_t>> With(const std::vector<OpenJobs>& open);

 private:
  JobStore& jobs_;
  std::mutex mutex_;
  std::optional<Stopwatch> since_;  ///< they were counted
  std::map<JobState, int64_t> ended_;
};

}  // namespace slicefarm::coordinator
