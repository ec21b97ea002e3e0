#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "services/coordinator/store/jobs/job_record.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// The columns that ReadJob reads, in its order, with `spec` in the place of the spec.
std::string JobColumns(std::string_view spec);
inline std::string JobColumns(const SqlDialect& dialect) { return JobColumns(dialect.spec); }

/// States in which a job has not ended.
#define SLICEFARM_OPEN "state IN ('QUEUED', 'RUNNING')"

/// The job of the row that `query` stands on. Errors: DATA_LOSS if it is damaged; `job` has what
/// could be read.
absl::Status ReadJob(const SqlQuery& query, JobRecord& job);

/// The job, or JOB_NOT_FOUND.
absl::StatusOr<JobRecord> FindJob(SqlConnection& db, const std::string& id);

/// The same, with an empty spec.
absl::StatusOr<JobRecord> FindJobWithoutSpec(SqlConnection& db, const std::string& id);

/// FindJobWithoutSpec in a transaction that will write to it: nobody else does before its end.
absl::StatusOr<JobRecord> LockJob(SqlConnection& db, const std::string& id);

/// The same, if nobody else is writing to it.
absl::StatusOr<JobRecord> LockFreeJob(SqlConnection& db, const std::string& id);

/// Appends an event of the job's present state, of which others are told. In a transaction.
absl::Status AppendEvent(SqlConnection& db, const JobRecord& job, int64_t now_us);

/// Writes all columns of `job` that change in its life, with an event of its present state. In a
/// transaction.
absl::Status WriteStep(SqlConnection& db, JobRecord& job, int64_t now_us);

}  // namespace slicefarm::coordinator
