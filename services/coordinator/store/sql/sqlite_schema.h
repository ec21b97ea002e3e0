#pragma once

#include <cstdint>

#include "absl/status/status.h"
#include "services/coordinator/store/sql/sqlite_connection.h"

namespace slicefarm::coordinator {

/// Brings a database, which may be new or of an older version, to the schema of this build, with
/// one transaction per migration. Then makes additions that do not change the version, so that a
/// previous build can still use the database. `to`: version at which tests of migrations stop.
/// Errors: FailedPrecondition if a newer build has written the database.
absl::Status MigrateSqlite(SqliteConnection& db, int64_t to = INT64_MAX);

}  // namespace slicefarm::coordinator
