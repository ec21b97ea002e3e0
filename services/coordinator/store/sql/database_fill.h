#pragma once

#include <cstdint>

#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Fill level of a PostgreSQL database.
struct DatabaseFill {
  int64_t bytes = 0;  ///< size of its files without the free space that deleted blobs left
  int64_t connections = 0;
  int64_t max_connections = 0;
};

/// Returns the fill level. Cost: reads the table of blobs, without their bytes.
absl::StatusOr<DatabaseFill> FillOf(SqlDatabase& database);

}  // namespace slicefarm::coordinator
