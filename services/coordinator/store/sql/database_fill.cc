#include "services/coordinator/store/sql/database_fill.h"

namespace slicefarm::coordinator {

/// Files do not get smaller when rows go, but the next rows take their place: so blobs, which are
/// nearly all of it, are counted by their bytes.
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
