#pragma once

#include <cstdint>

#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Fill level of a PostgreSQL database.
struct DatabaseFill {
  /// Size of the database files without the space that deleted blobs left free in them.
  int64_t bytes = 0;
  int64_t connections = 0;
  int64_t max_connections = 0;
};

/// Returns the fill level. Cost: reads the table of blobs, without their bytes. Errors: see
/// SqlDatabase.
absl::StatusOr<DatabaseFill> FillOf(SqlDatabase& database);

}  // namespace slicefarm::coordinator
