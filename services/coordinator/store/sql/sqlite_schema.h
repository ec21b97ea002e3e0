#pragma once

#include <cstdint>

#include "absl/status/status.h"
#include "services/coordinator/store/sql/sqlite_connection.h"

namespace slicefarm::coordinator {

/// Brings a database, new or of an older version, to the schema of this build, one migration a
/// transaction; then adds what changes no version, so that the build before goes on with it: that
/// is the way back. Errors: FailedPrecondition if a newer build's version is in it. Tests of
/// migrations stop at version `to`.
absl::Status MigrateSqlite(SqliteConnection& db, int64_t to = INT64_MAX);

}  // namespace slicefarm::coordinator
