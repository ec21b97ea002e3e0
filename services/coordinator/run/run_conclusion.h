#pragma once

#include <cstdint>

#include "absl/status/status.h"
#include "services/coordinator/algo/pipeline/job_pipeline.h"
#include "services/coordinator/run/lost_runs.h"
#include "services/coordinator/run/run_requests.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// Returns the update of a claimed job after its run ended with `error`. Pure.
///
///   its client has cancelled it                           CANCELLED.
///   the coordinator stops                                 QUEUED, at once.
///   its deadline has passed                               FAILED.
///   the disk is full                                      QUEUED, in 10 s, any number of times.
///   a store failed                                        QUEUED, in 0.5 s, doubling up to 60 s.
///   the run frees memory for other jobs                   QUEUED, in 1 s, any number of times.
///   services are of another build                         QUEUED, in 5 s, any number of times.
///   a stage has no reachable server (StageIsAway)         QUEUED, in 1 s, any number of times.
///   services are unreachable otherwise                    QUEUED, in 0.5 s, doubling, five times.
///   the workers of a range died at each try, or a stage   QUEUED, until LostRuns allows it; FAILED
///   of the whole job was lost twice                       after the third such run.
///   JOB_POISONED: coordinators may die of the job         QUEUED, until LostRuns allows it; FAILED
///                                                         after 10 lost runs.
///   any other error                                       FAILED.
///
/// "Doubling": each wait is twice as long as the previous wait. After the death of workers or
/// stages the job may run again, because they may have died for another reason.
JobUpdate Conclusion(const JobRecord& job, const LostRuns& lost_runs, const RunRequests& wishes,
                     const absl::Status& error, const PipelineProgress& reported, int64_t now_us);

/// Returns true for the error of a call that found no reachable server of its stage (StagePool).
bool StageIsAway(const absl::Status& error);

/// Returns the error of a job that has not ended by its deadline.
JobError DeadlinePassed();

}  // namespace slicefarm::coordinator
