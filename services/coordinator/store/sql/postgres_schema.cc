#include "services/coordinator/store/sql/postgres_schema.h"

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "services/coordinator/store/sql/postgres_migrations.h"

namespace slicefarm::coordinator {
namespace {

/// Largest `slicefarm_schema.version` that this build supports.
constexpr int64_t kKnownVersion = 8;

/// Longest wait of a step for a lock. Other transactions wait behind it for this time.
constexpr std::string_view kLockTimeout = "SET lock_timeout = '2s'";
constexpr int kLockTries = 100;
constexpr std::chrono::milliseconds kLockPause{1'000};
constexpr std::chrono::milliseconds kSchemaPause{200};

/// Returns true if the first column of the first row is true.
absl::StatusOr<bool> Ask(SqlConnection& db, std::string_view sql) {
  SqlQuery query(db, sql);
  const bool yes = query.Next() && query.Int(0) != 0;
  if (!query.status().ok()) return query.status();
  return yes;
}

/// Right to change the schema, held for the lifetime of this object. It is requested repeatedly
/// instead of with one waiting statement, because CREATE INDEX CONCURRENTLY would wait for such a
/// statement.
class SchemaLock {
 public:
  explicit SchemaLock(SqlConnection& db) : db_(db) {}
  SchemaLock(const SchemaLock&) = delete;
  SchemaLock& operator=(const SchemaLock&) = delete;
  ~SchemaLock() {
    if (mine_) Ask(db_, "SELECT pg_advisory_unlock(5117317)").IgnoreError();
  }

  absl::Status Await(const CancelToken& cancel) {
    while (!mine_) {
      if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
      const auto mine = Ask(db_, "SELECT pg_try_advisory_lock(5117317)");
      if (!mine.ok()) return mine.status();
      mine_ = *mine;
      if (!mine_) std::this_thread::sleep_for(kSchemaPause);
    }
    return absl::OkStatus();
  }

 private:
  SqlConnection& db_;
  bool mine_ = false;
};

absl::StatusOr<int64_t> Version(SqlConnection& db) {
  SqlQuery query(db, "SELECT version FROM slicefarm_schema");
  const int64_t version = query.Next() ? query.Int(0) : 0;
  if (!query.status().ok()) return query.status();
  return version;
}

absl::StatusOr<bool> WasTaken(SqlConnection& db, const PostgresMigration& step, int64_t number) {
  if (number <= kKnownVersion) {
    const auto version = Version(db);
    if (!version.ok()) return version.status();
    return number <= *version;
  }
  SqlQuery query(db, "SELECT 1 FROM slicefarm_migrations WHERE name = ?");
  const bool taken = query.Bind(step.name).Next();
  if (!query.status().ok()) return query.status();
  return taken;
}

absl::Status NoteTaken(SqlConnection& db, const PostgresMigration& step, int64_t number) {
  if (number <= kKnownVersion)
    return SqlQuery(db, "UPDATE slicefarm_schema SET version = ?").Bind(number).Run();
  return SqlQuery(db, "INSERT INTO slicefarm_migrations (name) VALUES (?)").Bind(step.name).Run();
}

/// Drops the invalid, useless indexes that remain if a program is killed while it creates an index.
absl::Status DropHalves(SqlConnection& db) {
  std::vector<std::string> names;
  SqlQuery query(
      db,
      "SELECT quote_ident(relname) FROM pg_index JOIN pg_class ON oid = indexrelid"
      " WHERE NOT indisvalid AND relnamespace = to_regnamespace(quote_ident(current_schema()))");
  while (query.Next()) names.push_back(query.Text(0));
  if (!query.status().ok()) return query.status();
  for (const std::string& name : names) {
    const absl::Status dropped = db.Execute("DROP INDEX CONCURRENTLY IF EXISTS " + name);
    if (!dropped.ok()) return dropped;
  }
  return absl::OkStatus();
}

absl::Status TakeBesideOthers(SqlConnection& db, const PostgresMigration& step, int64_t number) {
  if (absl::Status done = db.Execute("SET lock_timeout = 0"); !done.ok()) return done;
  if (absl::Status done = DropHalves(db); !done.ok()) return done;
  if (absl::Status done = db.Execute(std::string(step.sql)); !done.ok()) return done;
  return NoteTaken(db, step, number);
}

absl::Status TakeAtOnce(SqlConnection& db, const PostgresMigration& step, int64_t number) {
  if (absl::Status done = db.Execute(std::string(kLockTimeout)); !done.ok()) return done;
  SqlTransaction transaction(db);
  if (!transaction.status().ok()) return transaction.status();
  if (absl::Status done = db.Execute(std::string(step.sql)); !done.ok()) return done;
  if (absl::Status done = NoteTaken(db, step, number); !done.ok()) return done;
  return transaction.Commit();
}

absl::Status Take(SqlConnection& db, const PostgresMigration& step, int64_t number,
                  const CancelToken& cancel) {
  if (step.sql.find("CONCURRENTLY") != std::string_view::npos)
    return TakeBesideOthers(db, step, number);
  absl::Status taken;
  for (int tries = 1; tries <= kLockTries; ++tries) {
    taken = TakeAtOnce(db, step, number);
    if (!absl::IsUnavailable(taken)) return taken;
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    std::this_thread::sleep_for(kLockPause);
  }
  return taken;
}

absl::Status CheckVersion(SqlConnection& db) {
  const auto version = Version(db);
  if (!version.ok()) return version.status();
  if (*version <= kKnownVersion) return absl::OkStatus();
  return MakeError(
      absl::StatusCode::kFailedPrecondition, Reason::kStoreFailed,
      absl::StrCat("the database has version ", *version, ", this build knows ", kKnownVersion));
}

}  // namespace

std::span<const PostgresMigration> PostgresMigrations() { return kPostgresMigrations; }

absl::Status MigratePostgres(SqlConnection& db, std::span<const PostgresMigration> steps,
                             const Migrated& migrated, const CancelToken& cancel) {
  SchemaLock schema(db);
  if (absl::Status mine = schema.Await(cancel); !mine.ok()) return mine;
  const absl::Status ready = db.Execute(
      "CREATE TABLE IF NOT EXISTS slicefarm_schema (version BIGINT NOT NULL);"
      "INSERT INTO slicefarm_schema SELECT 0 WHERE NOT EXISTS (SELECT 1 FROM slicefarm_schema);"
      "CREATE TABLE IF NOT EXISTS slicefarm_migrations"
      " (name TEXT PRIMARY KEY, taken TIMESTAMPTZ NOT NULL DEFAULT now());");
  if (!ready.ok()) return ready;
  if (absl::Status known = CheckVersion(db); !known.ok()) return known;
  int64_t number = 0;
  for (const PostgresMigration& step : steps) {
    const auto taken = WasTaken(db, step, ++number);
    if (!taken.ok()) return taken.status();
    if (*taken) continue;
    if (absl::Status done = Take(db, step, number, cancel); !done.ok()) return done;
    if (migrated) migrated(step.name);
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::coordinator
