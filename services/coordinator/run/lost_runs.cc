#include "services/coordinator/run/lost_runs.h"

#include <fmt/core.h>

#include <algorithm>

#include "common/base/error.h"

namespace slicefarm::coordinator {
namespace {

constexpr int64_t kFirstCalmUs = 4'000'000;

/// How calm a coordinator has to be. Jobs that were lost beside each other begin at different
/// times, so that the one that coordinators die of is alone some day.
int64_t CalmUs(const JobRecord& job) {
  const int doublings = std::min(job.lost_runs, kMaxLostRuns) - kSuspectRuns;
  const int64_t eighths = job.lost_runs % 2 == 0 ? job.number % 8 : job.number / 8 % 8;
  return (kFirstCalmUs << doublings) * (8 + eighths) / 8;
}

}  // namespace

LostRuns::LostRuns(const JobRecord& job, int64_t calm_us) : count_(job.lost_runs) {
  if (count_ < kSuspectRuns) return;
  // Else it would take one calm coordinator after the other.
  const bool was_lost = job.state == JobState::kRunning;
  const int64_t before_us = was_lost ? 0 : std::max<int64_t>(0, calm_us);
  rest_us_ = std::max<int64_t>(0, CalmUs(job) - before_us);
}

absl::Status LostRuns::MayBegin() const {
  if (!condemned() && rest_us_ == 0) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInternal, Reason::kJobPoisoned,
                   fmt::format("{} runs of this job began and came to no end", count_),
                   {{"lost_runs", fmt::format("{}", count_)}});
}

int32_t LostRuns::After(JobState state) const {
  return count_ + (state == JobState::kRunning ? 1 : 0);
}

}  // namespace slicefarm::coordinator
