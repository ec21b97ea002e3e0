#pragma once

#include <cstdint>

#include "absl/status/status.h"
#include "services/coordinator/store/sql/sqlite_connection.h"

namespace slicefarm::coordinator {

/// Brings a database, new or of an older version, to the schema of this build, with one transaction
/// per migration. Then makes the additions that do not change the version, so that a return to the
/// previous build is possible. Errors: FailedPrecondition if the database has the version of a
/// newer build. `to`: version at which tests of migrations stop.
absl::Status MigrateSqlite(SqliteConnection& db, int64_t to = INT64_MAX);

}  // namespace slicefarm::coordinator
