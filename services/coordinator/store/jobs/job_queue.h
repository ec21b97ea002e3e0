#pragma once

#include "absl/status/statusor.h"
#include "services/coordinator/algo/queue_order.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// JobStore::ReadQueue in SQL.
absl::StatusOr<QueueSnapshot> ReadQueue(SqlConnection& db, int64_t now_us);

/// The statements, for a test of how they are planned.
std::string WaitingSql(const SqlDialect& dialect);
std::string HeldSql(const SqlDialect& dialect);
std::string LatestRunsSql(const SqlDialect& dialect);

}  // namespace slicefarm::coordinator
