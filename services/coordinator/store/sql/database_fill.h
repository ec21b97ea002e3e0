#pragma once

#include <cstdint>

#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// How full a PostgreSQL database is.
struct DatabaseFill {
  int64_t bytes = 0;  ///< of its files, without what deleted blobs left free in theirs
  int64_t connections = 0;
  int64_t max_connections = 0;
};

/// Cost: reads the table of blobs, without their bytes.
absl::StatusOr<DatabaseFill> FillOf(SqlDatabase& database);

}  // namespace slicefarm::coordinator
