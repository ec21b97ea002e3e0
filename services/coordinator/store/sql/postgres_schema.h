#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "common/base/cancel_token.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Migration step of the schema: a file of `deploy/postgres`.
///
/// A step with CREATE INDEX CONCURRENTLY consists of this statement alone, with IF NOT EXISTS. It
/// may take long, and other transactions continue meanwhile. Any other step is one transaction. It
/// is tried repeatedly with a short lock timeout, because all other transactions would wait behind
/// a step that waits for a lock.
struct PostgresMigration {
  std::string_view name;
  std::string_view sql;
};

/// Returns the steps of this build, in their order.
std::span<const PostgresMigration> PostgresMigrations();

/// Function that is called with the name of each step that was taken.
using Migrated = std::function<void(std::string_view name)>;

/// Takes the steps that a database lacks. Only one program at a time does so. After an
/// interruption, the next call continues at the same step.
///
/// The first eight steps increase `slicefarm_schema.version`; a build refuses a database with a
/// larger version than it supports. Later steps are recorded by name in `slicefarm_migrations`.
/// They only add to the schema, so older builds can use the database as well. A step that removes
/// something would have to increase the version.
///
/// Errors: STORE_FAILED; FailedPrecondition if the schema needs a newer build; Unavailable if a
/// lock was not available for minutes; the error of `cancel`.
absl::Status MigratePostgres(SqlConnection& db,
                             std::span<const PostgresMigration> steps = PostgresMigrations(),
                             const Migrated& migrated = {}, const CancelToken& cancel = {});

}  // namespace slicefarm::coordinator
