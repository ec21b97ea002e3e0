#pragma once

#include <cstdint>
#include <optional>

#include "absl/status/status.h"
#include "services/coordinator/store/jobs/job_record.h"

namespace slicefarm::coordinator {

/// A job that lost so many runs may be what its coordinators die of: it is a suspect.
inline constexpr int32_t kSuspectRuns = 3;

/// A job that lost so many runs has killed its coordinators, as far as can be told.
inline constexpr int32_t kMaxLostRuns = 10;

/// A job with so many deadly runs has killed its workers or stages, as far as can be told.
inline constexpr int32_t kMaxDeadlyRuns = 3;

/// What the lost runs of a job, which began and came to no end, and its deadly ones, which ended
/// because services died in the middle of them, mean for its next one. Pure.
///
/// Runs are lost by what the job does to its coordinators, and by what else happens to those. The
/// second happens whatever they run, so it is told by their calm: how long one has lived and lost
/// no claim. A suspect begins on calm coordinators alone, after each loss on those that were calm
/// twice as long. Where coordinators are killed all the time, none is, and suspects wait for better
/// days, which costs them time and no run. Where coordinators live until the job runs, each of its
/// runs counts, and the last one is soon reached.
/// Services die of the same things, so the same holds after a deadly run: coordinators that are
/// calm tell of a farm that is.
class LostRuns {
 public:
  LostRuns() = default;

  /// Of a job as it was claimed by a coordinator that has been calm for `calm_us`.
  LostRuns(const JobRecord& job, int64_t calm_us);

  /// Whether a run may begin. Errors: JOB_POISONED.
  absl::Status MayBegin() const;

  /// True: coordinators die of the job. False: it is to run again, after `rest_us`.
  bool condemned() const { return count_ >= kMaxLostRuns; }
  int64_t rest_us() const { return rest_us_; }

  /// What becomes of the job after one more run, which was deadly: how long it rests, or nullopt:
  /// services die of it.
  std::optional<int64_t> RestAfterDeadlyRunUs() const;

  /// What a run is to write with `state`: RUNNING may be the last that is heard of it.
  int32_t After(JobState state) const;

 private:
  int32_t count_ = 0;
  int32_t deadly_ = 0;
  int64_t number_ = 0;
  int64_t rest_us_ = 0;
};

}  // namespace slicefarm::coordinator
