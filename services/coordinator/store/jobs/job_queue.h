#pragma once

#include "absl/status/statusor.h"
#include "services/coordinator/algo/queue_order.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Implements JobStore::ReadQueue in SQL.
absl::StatusOr<QueueSnapshot> ReadQueue(SqlConnection& db, int64_t now_us);

/// Returns the SQL that reads the waiting jobs; public for a test of its query plan.
std::string WaitingSql(const SqlDialect& dialect);
/// Returns the SQL that reads the held jobs; public for a test of its query plan.
std::string HeldSql(const SqlDialect& dialect);
/// Returns the SQL that reads the latest runs; public for a test of its query plan.
std::string LatestRunsSql(const SqlDialect& dialect);

}  // namespace slicefarm::coordinator
