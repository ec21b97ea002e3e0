#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "common/base/cancel_token.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// A step of the schema: a file of `deploy/postgres`.
///
/// One with CREATE INDEX CONCURRENTLY has that statement alone, with IF NOT EXISTS, and goes on for
/// as long as it takes beside everything else. Any other is a transaction, which is tried again and
/// again rather than wait for a lock with everybody behind it.
struct PostgresMigration {
  std::string_view name;
  std::string_view sql;
};

/// Those of this build, in their order.
std::span<const PostgresMigration> PostgresMigrations();

/// Is told of each step that was taken.
using Migrated = std::function<void(std::string_view name)>;

/// Takes the steps that a database lacks, one process at a time; one that was ended goes on where
/// it was. The first eight count `slicefarm_schema.version` up, above which a build refuses a
/// database. Later ones stand in `slicefarm_migrations` by their names: they add, so builds that do
/// not know them go on, and start, beside them. One that takes something away would set the
/// version. Errors: STORE_FAILED, FailedPrecondition if the schema needs a newer build, Unavailable
/// if a lock was not to be had for minutes; `cancel`'s.
absl::Status MigratePostgres(SqlConnection& db,
                             std::span<const PostgresMigration> steps = PostgresMigrations(),
                             const Migrated& migrated = {}, const CancelToken& cancel = {});

}  // namespace slicefarm::coordinator
