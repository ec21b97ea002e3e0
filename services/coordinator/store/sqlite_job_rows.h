#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "services/coordinator/store/job_record.h"
#include "services/coordinator/store/sqlite_connection.h"

namespace slicefarm::coordinator {

/// The columns that ReadJob reads, in its order.
#define SLICEFARM_JOB_COLUMNS                                                               \
  "number, id, state, spec, labels, settings_digest, action_digest, build_id, create_us, "  \
  "start_us, end_us, layers_total, layers_done, error, result, cancel_requested, retries, " \
  "last_sequence, owner, owner_epoch, owner_until_us, store_failures"

/// Which jobs can be claimed; parameters: the time, and a list of busy digests.
#define SLICEFARM_CLAIMABLE                                 \
  " state IN ('QUEUED', 'RUNNING') AND owner_until_us <= ?" \
  " AND action_digest NOT IN (SELECT value FROM json_each(?))"

inline constexpr char kAnyClaimableSql[] =
    "SELECT 1 FROM jobs WHERE" SLICEFARM_CLAIMABLE " LIMIT 1";

/// Claims the oldest job; parameters: owner, until when, and those of SLICEFARM_CLAIMABLE.
inline constexpr char kClaimJobSql[] =
    "UPDATE jobs SET owner = ?, owner_epoch = owner_epoch + 1, owner_until_us = ?"
    " WHERE number = (SELECT number FROM jobs WHERE" SLICEFARM_CLAIMABLE
    " ORDER BY number LIMIT 1) RETURNING " SLICEFARM_JOB_COLUMNS;

/// The job of the row that `query` stands on. Errors: STORE_FAILED if it is damaged.
absl::StatusOr<JobRecord> ReadJob(const SqliteQuery& query);

/// All rows. Errors: those of the query and of ReadJob.
absl::StatusOr<std::vector<JobRecord>> ReadJobs(SqliteQuery& query);

/// The job, or JOB_NOT_FOUND.
absl::StatusOr<JobRecord> FindJob(SqliteConnection& db, const std::string& id);

/// Writes all columns of `job` that change in its life, with an event of its present state. In a
/// transaction.
absl::Status WriteStep(SqliteConnection& db, JobRecord& job, int64_t now_us);

}  // namespace slicefarm::coordinator
