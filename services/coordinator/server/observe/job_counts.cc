#include "services/coordinator/server/observe/job_counts.h"

#include <utility>

namespace slicefarm::coordinator {
namespace {

constexpr double kCountedForS = 60;

}  // namespace

absl::StatusOr<std::map<JobState, int64_t>> JobCounts::With(const std::vector<OpenJobs>& open) {
  const std::lock_guard lock(mutex_);
  if (!since_ || since_->Seconds() > kCountedForS) {
    auto ended = jobs_.CountEnded();
    if (!ended.ok()) return ended.status();
    ended_ = *std::move(ended);
    since_.emplace();
  }
  std::map<JobState, int64_t> counts = ended_;
  for (const OpenJobs& jobs : open) counts[jobs.state] += jobs.count;
  return counts;
}

}  // namespace slicefarm::coordinator
