#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "services/coordinator/store/jobs/job_record.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// The columns that ReadJob reads, in its order.
#define SLICEFARM_JOB_COLUMNS SLICEFARM_JOB_COLUMNS_WITH("spec")

/// The same with something else in place of the spec.
#define SLICEFARM_JOB_COLUMNS_WITH(spec)                                                           \
  "number, id, tenant, state, priority, deadline_us, " spec                                        \
  ", labels, settings_digest, action_digest, build_id, traceparent, create_us, start_us, end_us, " \
  "layers_total, "                                                                                 \
  "layers_done, error, result, cancel_requested, retries, store_failures, lost_runs, "             \
  "last_sequence, trace_sha256, owner, owner_epoch, owner_until_us"

/// States in which a job has not ended.
#define SLICEFARM_OPEN "state IN ('QUEUED', 'RUNNING')"

/// The job of the row that `query` stands on. Errors: DATA_LOSS if it is damaged; `job` has what
/// could be read.
absl::Status ReadJob(const SqlQuery& query, JobRecord& job);

/// The job, or JOB_NOT_FOUND.
absl::StatusOr<JobRecord> FindJob(SqlConnection& db, const std::string& id);

/// The same, with an empty spec.
absl::StatusOr<JobRecord> FindJobWithoutSpec(SqlConnection& db, const std::string& id);

/// FindJob in a transaction that will write to it: nobody else does before its end.
absl::StatusOr<JobRecord> LockJob(SqlConnection& db, const std::string& id);

/// The same, if nobody else is writing to it.
absl::StatusOr<JobRecord> LockFreeJob(SqlConnection& db, const std::string& id);

/// Writes all columns of `job` that change in its life, with an event of its present state. In a
/// transaction.
absl::Status WriteStep(SqlConnection& db, JobRecord& job, int64_t now_us);

}  // namespace slicefarm::coordinator
