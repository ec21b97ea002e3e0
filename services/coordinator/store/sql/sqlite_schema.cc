#include "services/coordinator/store/sql/sqlite_schema.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <string_view>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"

namespace slicefarm::coordinator {
namespace {

/// Migrations. Migration i changes version i to i + 1, which builds for an older version refuse.
/// Released migrations never change.
constexpr std::array kMigrations = {
    R"(
CREATE TABLE jobs (
  number          INTEGER PRIMARY KEY AUTOINCREMENT,
  id              TEXT    NOT NULL UNIQUE,
  state           TEXT    NOT NULL,
  spec            BLOB    NOT NULL,
  labels          TEXT    NOT NULL,           -- JSON
  settings_digest TEXT    NOT NULL,
  action_digest   TEXT    NOT NULL,
  build_id        TEXT    NOT NULL,
  create_us       INTEGER NOT NULL,
  start_us        INTEGER NOT NULL DEFAULT 0,
  end_us          INTEGER NOT NULL DEFAULT 0,
  layers_total    INTEGER NOT NULL DEFAULT 0,
  layers_done     INTEGER NOT NULL DEFAULT 0,
  error           TEXT    NOT NULL DEFAULT '',  -- JSON; '': none
  result          TEXT    NOT NULL DEFAULT '',  -- JSON; '': none
  gcode_sha256    TEXT    NOT NULL DEFAULT '',  -- of result: what refers to a blob
  report_sha256   TEXT    NOT NULL DEFAULT '',
  cancel_requested INTEGER NOT NULL DEFAULT 0,
  retries        INTEGER NOT NULL DEFAULT 0,
  last_sequence   INTEGER NOT NULL DEFAULT 0,
  owner           TEXT    NOT NULL DEFAULT '',
  owner_epoch     INTEGER NOT NULL DEFAULT 0,
  owner_until_us  INTEGER NOT NULL DEFAULT 0
) STRICT;
CREATE INDEX jobs_open ON jobs (number) WHERE state IN ('QUEUED', 'RUNNING');
CREATE INDEX jobs_by_state ON jobs (state, number);
CREATE INDEX jobs_by_gcode ON jobs (gcode_sha256) WHERE gcode_sha256 <> '';
CREATE INDEX jobs_by_report ON jobs (report_sha256) WHERE report_sha256 <> '';

CREATE TABLE events (
  job          INTEGER NOT NULL REFERENCES jobs (number) ON DELETE CASCADE,
  sequence     INTEGER NOT NULL,
  time_us      INTEGER NOT NULL,
  state        TEXT    NOT NULL,
  layers_total INTEGER NOT NULL,
  layers_done  INTEGER NOT NULL,
  PRIMARY KEY (job, sequence)
) STRICT, WITHOUT ROWID;

CREATE TABLE requests (
  request_id  TEXT    PRIMARY KEY,
  job_id      TEXT    NOT NULL,
  spec_digest TEXT    NOT NULL,
  create_us   INTEGER NOT NULL
) STRICT, WITHOUT ROWID;
CREATE INDEX requests_by_age ON requests (create_us);

CREATE TABLE results (
  action_digest TEXT PRIMARY KEY,
  result        TEXT NOT NULL,  -- JSON
  gcode_sha256  TEXT NOT NULL,
  report_sha256 TEXT NOT NULL
) STRICT, WITHOUT ROWID;
CREATE INDEX results_by_gcode ON results (gcode_sha256);
CREATE INDEX results_by_report ON results (report_sha256);
)",
    R"(
ALTER TABLE jobs ADD COLUMN store_failures INTEGER NOT NULL DEFAULT 0;
)",
    R"(
CREATE INDEX requests_by_job ON requests (job_id);
)",
    R"(
ALTER TABLE jobs ADD COLUMN tenant TEXT NOT NULL DEFAULT '';
ALTER TABLE jobs ADD COLUMN priority INTEGER NOT NULL DEFAULT 1;
ALTER TABLE jobs ADD COLUMN deadline_us INTEGER NOT NULL DEFAULT 9223372036854775807;
ALTER TABLE jobs ADD COLUMN traceparent TEXT NOT NULL DEFAULT '';
DROP INDEX jobs_open;
CREATE INDEX jobs_open ON jobs (tenant, priority DESC, deadline_us, number)
  WHERE state IN ('QUEUED', 'RUNNING');
CREATE INDEX jobs_held ON jobs (tenant) WHERE state IN ('QUEUED', 'RUNNING') AND owner <> '';
CREATE INDEX jobs_by_owner ON jobs (owner) WHERE owner <> '';
CREATE INDEX jobs_by_tenant ON jobs (tenant, number);
CREATE INDEX jobs_by_end ON jobs (end_us) WHERE end_us > 0;

CREATE TABLE tenants (
  tenant     TEXT    PRIMARY KEY,
  claimed_us INTEGER NOT NULL  -- a job of it, last
) STRICT, WITHOUT ROWID;

CREATE TABLE labels (
  job   INTEGER NOT NULL REFERENCES jobs (number) ON DELETE CASCADE,
  key   TEXT    NOT NULL,
  value TEXT    NOT NULL,
  PRIMARY KEY (job, key)
) STRICT, WITHOUT ROWID;
CREATE INDEX labels_by_value ON labels (key, value, job);
INSERT INTO labels (job, key, value)
  SELECT jobs.number, label.key, label.value FROM jobs, json_each(jobs.labels) AS label;

CREATE TABLE inputs (
  job    INTEGER NOT NULL REFERENCES jobs (number) ON DELETE CASCADE,
  digest TEXT    NOT NULL,
  PRIMARY KEY (job, digest)
) STRICT, WITHOUT ROWID;
CREATE INDEX inputs_by_digest ON inputs (digest);

ALTER TABLE requests RENAME TO old_requests;
CREATE TABLE requests (
  tenant      TEXT    NOT NULL,
  request_id  TEXT    NOT NULL,
  job_id      TEXT    NOT NULL,
  spec_digest TEXT    NOT NULL,
  create_us   INTEGER NOT NULL,
  PRIMARY KEY (tenant, request_id)
) STRICT, WITHOUT ROWID;
INSERT INTO requests SELECT '', request_id, job_id, spec_digest, create_us FROM old_requests;
DROP TABLE old_requests;
CREATE INDEX requests_by_age ON requests (create_us);
CREATE INDEX requests_by_job ON requests (job_id);
)",
    R"(
CREATE TABLE profiles (
  tenant          TEXT    NOT NULL,
  name            TEXT    NOT NULL,
  revision        INTEGER NOT NULL,
  settings        BLOB    NOT NULL,
  settings_digest TEXT    NOT NULL,
  create_us       INTEGER NOT NULL,
  PRIMARY KEY (tenant, name, revision)
) STRICT, WITHOUT ROWID;
)",
    R"(
CREATE TABLE webhooks (
  job      INTEGER PRIMARY KEY REFERENCES jobs (number) ON DELETE CASCADE,
  url      TEXT    NOT NULL,
  state    TEXT    NOT NULL,
  due_us   INTEGER NOT NULL,
  attempts INTEGER NOT NULL
) STRICT;
CREATE INDEX webhooks_due ON webhooks (due_us) WHERE state = 'DUE';

CREATE TABLE webhook_attempts (
  job         INTEGER NOT NULL REFERENCES jobs (number) ON DELETE CASCADE,
  attempt     INTEGER NOT NULL,
  time_us     INTEGER NOT NULL,
  http_status INTEGER NOT NULL,
  error       TEXT    NOT NULL,
  PRIMARY KEY (job, attempt)
) STRICT, WITHOUT ROWID;
)",
    R"(
ALTER TABLE jobs ADD COLUMN trace_sha256 TEXT NOT NULL DEFAULT '';
CREATE INDEX jobs_by_trace ON jobs (trace_sha256) WHERE trace_sha256 <> '';
)",
    R"(
ALTER TABLE results ADD COLUMN tenant TEXT NOT NULL DEFAULT '';     -- whose blobs they are
ALTER TABLE jobs ADD COLUMN result_tenant TEXT NOT NULL DEFAULT '';  -- of result
)",
    R"(
ALTER TABLE jobs ADD COLUMN lost_runs INTEGER NOT NULL DEFAULT 0;
)",
    // With these columns, lists skip unwanted jobs without reading their rows.
    R"(
DROP INDEX jobs_by_tenant;
CREATE INDEX jobs_by_tenant ON jobs (tenant, number, priority, create_us, state);
)",
    // Index by which a claim finds held jobs with the same work.
    R"(
CREATE INDEX jobs_held_work ON jobs (action_digest)
  WHERE state IN ('QUEUED', 'RUNNING') AND owner <> '';
)",
    // An update writes the whole row again, and a spec may have a MiB, so specs have a table of
    // their own.
    R"(
CREATE TABLE specs (
  job  INTEGER PRIMARY KEY REFERENCES jobs (number) ON DELETE CASCADE,
  spec BLOB    NOT NULL
) STRICT;
INSERT INTO specs SELECT number, spec FROM jobs;
ALTER TABLE jobs DROP COLUMN spec;

CREATE TABLE chores (
  name     TEXT    PRIMARY KEY,
  until_us INTEGER NOT NULL  -- nobody else does it before
) STRICT, WITHOUT ROWID;
)",
};

/// Later step that only adds to the schema. Builds that do not support it can run beside it, so it
/// does not change the version. It is recorded by its name in the table `migrations`.
struct Addition {
  std::string_view name;
  std::string_view sql;
};

constexpr Addition kAdditions[] = {
    {"s3", R"(
CREATE TABLE s3_blobs (
  tenant     TEXT    NOT NULL,
  digest     TEXT    NOT NULL,
  object     TEXT    NOT NULL,  -- its key, without the prefix of the bucket's address
  size       INTEGER NOT NULL,
  touched_us INTEGER NOT NULL,  -- put or asked for, last
  PRIMARY KEY (tenant, digest)
) STRICT, WITHOUT ROWID;

CREATE TABLE s3_loose (
  object   TEXT    PRIMARY KEY,
  tenant   TEXT    NOT NULL,
  state    TEXT    NOT NULL,  -- PUTTING: is about to be a blob; GONE: was one; DAMAGED: the same
  since_us INTEGER NOT NULL
) STRICT, WITHOUT ROWID;
CREATE INDEX s3_loose_by_tenant ON s3_loose (tenant);
)"},
    // A watcher of all jobs of a tenant continues from a point in time.
    {"events_by_time", "CREATE INDEX events_by_time ON events (time_us, job, sequence);"},
    {"deadly_runs", "ALTER TABLE jobs ADD COLUMN deadly_runs INTEGER NOT NULL DEFAULT 0;"},
    {"presets", R"(
CREATE TABLE presets (
  tenant          TEXT    NOT NULL,
  name            TEXT    NOT NULL,
  revision        INTEGER NOT NULL,
  settings        BLOB    NOT NULL,  -- the files, compressed
  settings_digest TEXT    NOT NULL,
  create_us       INTEGER NOT NULL,
  PRIMARY KEY (tenant, name, revision)
) STRICT;
)"},
};

absl::StatusOr<int64_t> Version(SqliteConnection& db) {
  SqlQuery query(db, "PRAGMA user_version");
  const int64_t version = query.Next() ? query.Int(0) : 0;
  if (!query.status().ok()) return query.status();
  return version;
}

absl::StatusOr<bool> WasAdded(SqliteConnection& db, std::string_view name) {
  SqlQuery query(db, "SELECT 1 FROM migrations WHERE name = ?");
  const bool added = query.Bind(name).Next();
  if (!query.status().ok()) return query.status();
  return added;
}

/// Takes all missing additions in one transaction.
absl::Status TakeAdditions(SqliteConnection& db) {
  SqlTransaction transaction(db);
  if (!transaction.status().ok()) return transaction.status();
  absl::Status done =
      db.Execute("CREATE TABLE IF NOT EXISTS migrations (name TEXT PRIMARY KEY) STRICT");
  if (!done.ok()) return done;
  for (const Addition& step : kAdditions) {
    const auto added = WasAdded(db, step.name);
    if (!added.ok()) return added.status();
    if (*added) continue;
    if (done = db.Execute(std::string(step.sql)); !done.ok()) return done;
    SqlQuery note(db, "INSERT INTO migrations (name) VALUES (?)");
    if (done = note.Bind(step.name).Run(); !done.ok()) return done;
  }
  return transaction.Commit();
}

absl::Status MigrateVersions(SqliteConnection& db, int64_t to) {
  while (true) {
    SqlTransaction transaction(db);
    if (!transaction.status().ok()) return transaction.status();
    const auto version = Version(db);
    if (!version.ok()) return version.status();
    const auto known = static_cast<int64_t>(kMigrations.size());
    if (*version == std::min(to, known)) return transaction.Commit();
    if (*version > known) {
      return MakeError(
          absl::StatusCode::kFailedPrecondition, Reason::kStoreFailed,
          absl::StrCat("the database has version ", *version, ", this build knows ", known));
    }
    const std::string step =
        absl::StrCat(kMigrations[*version], "PRAGMA user_version = ", *version + 1, ";");
    if (absl::Status done = db.Execute(step); !done.ok()) return done;
    if (absl::Status done = transaction.Commit(); !done.ok()) return done;
  }
}

}  // namespace

absl::Status MigrateSqlite(SqliteConnection& db, int64_t to) {
  absl::Status migrated = MigrateVersions(db, to);
  if (!migrated.ok() || to < std::ssize(kMigrations)) return migrated;
  return TakeAdditions(db);
}

}  // namespace slicefarm::coordinator
