#pragma once

#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Brings a database to the present schema, the files of `deploy/postgres` one after the other.
/// Errors: STORE_FAILED, FailedPrecondition if the schema is of a newer build.
absl::Status MigratePostgres(SqlConnection& db);

}  // namespace slicefarm::coordinator
