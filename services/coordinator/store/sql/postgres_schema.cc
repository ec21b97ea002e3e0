#include "services/coordinator/store/sql/postgres_schema.h"

#include <string>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "services/coordinator/store/sql/postgres_migrations.h"

namespace slicefarm::coordinator {
namespace {

absl::StatusOr<int64_t> Version(SqlConnection& db) {
  SqlQuery query(db, "SELECT version FROM slicefarm_schema");
  const int64_t version = query.Next() ? query.Int(0) : 0;
  if (!query.status().ok()) return query.status();
  return version;
}

absl::Status MigrateFrom(SqlConnection& db, int64_t version) {
  const auto known = static_cast<int64_t>(kPostgresMigrations.size());
  if (version > known) {
    return MakeError(
        absl::StatusCode::kFailedPrecondition, Reason::kStoreFailed,
        absl::StrCat("the database has version ", version, ", this build knows ", known));
  }
  for (; version < known; ++version) {
    if (absl::Status done = db.Execute(kPostgresMigrations[version]); !done.ok()) return done;
  }
  return SqlQuery(db, "UPDATE slicefarm_schema SET version = ?").Bind(known).Run();
}

}  // namespace

absl::Status MigratePostgres(SqlConnection& db) {
  SqlTransaction transaction(db);
  if (!transaction.status().ok()) return transaction.status();
  // One coordinator at a time; the number is the name of this lock, until the transaction ends.
  absl::Status ready = db.Execute(
      "SELECT pg_advisory_xact_lock(5117317);"
      "CREATE TABLE IF NOT EXISTS slicefarm_schema (version BIGINT NOT NULL);"
      "INSERT INTO slicefarm_schema SELECT 0 WHERE NOT EXISTS (SELECT 1 FROM slicefarm_schema);");
  if (!ready.ok()) return ready;
  const auto version = Version(db);
  if (!version.ok()) return version.status();
  if (absl::Status done = MigrateFrom(db, *version); !done.ok()) return done;
  return transaction.Commit();
}

}  // namespace slicefarm::coordinator
