#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "services/coordinator/store/jobs/job_record.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Returns the columns that ReadJob needs, in its order. `spec`: SQL expression of the spec.
std::string JobColumns(std::string_view spec);
/// Returns the columns that ReadJob needs, with the dialect's expression of the spec.
inline std::string JobColumns(const SqlDialect& dialect) { return JobColumns(dialect.spec); }

/// SQL condition for the states of open jobs.
#define SLICEFARM_OPEN "state IN ('QUEUED', 'RUNNING')"

/// Reads the job from the current row of `query`. Errors: DATA_LOSS if it is damaged; `job` then
/// has the readable fields.
absl::Status ReadJob(const SqlQuery& query, JobRecord& job);

/// Returns the job. Errors: JOB_NOT_FOUND.
absl::StatusOr<JobRecord> FindJob(SqlConnection& db, const std::string& id);

/// Returns the job as FindJob does, with an empty spec.
absl::StatusOr<JobRecord> FindJobWithoutSpec(SqlConnection& db, const std::string& id);

/// Returns the job as FindJobWithoutSpec does, and locks it. REQUIRES: a transaction; until its
/// end, no other transaction writes to the job.
absl::StatusOr<JobRecord> LockJob(SqlConnection& db, const std::string& id);

/// Locks the job as LockJob does. If another transaction is writing to the job, does not wait and
/// returns JOB_NOT_FOUND.
absl::StatusOr<JobRecord> LockFreeJob(SqlConnection& db, const std::string& id);

/// Appends an event with the job's current state, and notifies other coordinators. REQUIRES: a
/// transaction.
absl::Status AppendEvent(SqlConnection& db, const JobRecord& job, int64_t now_us);

/// Writes all columns of `job` that can change, and appends an event with its current state.
/// REQUIRES: a transaction.
absl::Status WriteStep(SqlConnection& db, JobRecord& job, int64_t now_us);

}  // namespace slicefarm::coordinator
