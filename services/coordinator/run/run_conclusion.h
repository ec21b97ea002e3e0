#pragma once

#include <cstdint>

#include "absl/status/status.h"
#include "services/coordinator/algo/pipeline/job_pipeline.h"
#include "services/coordinator/run/lost_runs.h"
#include "services/coordinator/run/run_wishes.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// What a run that ended with `error` makes of its job, as it was claimed. Pure.
///
///   its client wants it to end                            CANCELLED
///   the coordinator stops                                 QUEUED, at once
///   its deadline has passed                               FAILED
///   the disk is full                                      QUEUED, in 10 s, however often
///   a store failed                                        QUEUED, in 0.5 s, ever later, up to 60 s
///   it makes room in memory for others                    QUEUED, in 1 s, however often
///   services are of another build                         QUEUED, in 5 s, however often
///   services are not there                                QUEUED, in 0.5 s, ever later, five times
///   the workers of a range died, each time, or a stage    QUEUED, until LostRuns lets it begin: it
///   of the whole job was lost, twice                      may have been something else that they
///                                                         died of; not after the third such run
///   JOB_POISONED: coordinators may die of it              QUEUED, until LostRuns lets it begin;
///                                                         not once 10 runs are lost
///   anything else                                         FAILED
///
/// "Ever later": twice as long each time.
JobUpdate Conclusion(const JobRecord& job, const LostRuns& lost_runs, const RunWishes& wishes,
                     const absl::Status& error, const PipelineProgress& told, int64_t now_us);

/// Why a job ends that has not ended by its deadline.
JobError DeadlinePassed();

}  // namespace slicefarm::coordinator
