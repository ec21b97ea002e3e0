#include "services/coordinator/run/lost_runs.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "common/base/error.h"

namespace slicefarm::coordinator {
namespace {

constexpr int64_t kFirstCalmUs = 4'000'000;

/// Returns the time without losses that a coordinator needs before the job's next run. `n`: number
/// of earlier waits of this kind. `number`: the job's number, which varies the time between jobs.
/// Jobs that were lost together thus begin at different times, and the job that kills coordinators
/// is alone at some time.
int64_t CalmUs(int n, int64_t number) {
  const int64_t eighths = n % 2 == 0 ? number / 8 % 8 : number % 8;
  return (kFirstCalmUs << n) * (8 + eighths) / 8;
}

int64_t CalmAfterLostRunsUs(int32_t runs, int64_t number) {
  return runs < kSuspectRuns ? 0 : CalmUs(std::min(runs, kMaxLostRuns) - kSuspectRuns, number);
}

/// Returns the time without losses that is needed after `runs` deadly runs: at least 8 s after the
/// first and 64 s after the second. These times are longer than after lost runs, because each
/// deadly run has killed services.
int64_t CalmAfterDeadlyRunsUs(int32_t runs, int64_t number) {
  return runs == 0 ? 0 : CalmUs(3 * std::min(runs, kMaxDeadlyRuns) - 2, number);
}

}  // namespace

LostRuns::LostRuns(const JobRecord& job, int64_t calm_us)
    : count_(job.lost_runs), deadly_(job.deadly_runs), number_(job.number) {
  const int64_t wanted_us =
      std::max(CalmAfterLostRunsUs(count_, number_), CalmAfterDeadlyRunsUs(deadly_, number_));
  // If the last run was lost, the calm time before this claim does not count. Otherwise the job
  // would kill one calm coordinator after another.
  const bool was_lost = job.state == JobState::kRunning;
  const int64_t before_us = was_lost ? 0 : std::max<int64_t>(0, calm_us);
  rest_us_ = std::max<int64_t>(0, wanted_us - before_us);
}

absl::Status LostRuns::MayBegin() const {
  if (!condemned() && rest_us_ == 0) return absl::OkStatus();
  const std::string text = condemned()
                               ? fmt::format(
                                     "the job is given up: {} of its runs started and did not end, "
                                     "probably because the job crashes the farm's services",
                                     count_)
                               : fmt::format(
                                     "the job is suspended: {} of its runs did not end, and {} of "
                                     "these runs crashed services",
                                     count_, deadly_);
  return MakeError(absl::StatusCode::kInternal, Reason::kJobPoisoned, text,
                   {{"lost_runs", fmt::format("{}", count_)}});
}

std::optional<int64_t> LostRuns::RestAfterDeadlyRunUs() const {
  if (deadly_ + 1 >= kMaxDeadlyRuns) return std::nullopt;
  return CalmAfterDeadlyRunsUs(deadly_ + 1, number_);
}

int32_t LostRuns::After(JobState state) const {
  return count_ + (state == JobState::kRunning ? 1 : 0);
}

}  // namespace slicefarm::coordinator
