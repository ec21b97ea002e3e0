#include "services/coordinator/store/sql/database_fill.h"

namespace slicefarm::coordinator {

/// The size of blobs is computed from their bytes, because blobs are nearly the whole database.
/// Files do not shrink when rows are deleted; new rows reuse the free space.
absl::StatusOr<DatabaseFill> FillOf(SqlDatabase& database) {
  const auto session = database.Read();
  if (!session.ok()) return session.status();
  SqlQuery query(**session,
                 "SELECT pg_database_size(current_database())"
                 " - pg_total_relation_size('blob_pieces')"
                 " + (SELECT coalesce(sum(size), 0) FROM blobs)::BIGINT,"
                 " (SELECT count(*) FROM pg_stat_activity WHERE backend_type = 'client backend'),"
                 " current_setting('max_connections')::BIGINT");
  if (!query.Next()) return query.status();
  return DatabaseFill{query.Int(0), query.Int(1), query.Int(2)};
}

}  // namespace slicefarm::coordinator
