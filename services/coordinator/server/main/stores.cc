#include "services/coordinator/server/main/stores.h"

#include <utility>

#include "services/coordinator/store/blobs/posix_file.h"
#include "services/coordinator/store/jobs/postgres_job_changes.h"
#include "services/coordinator/store/jobs/sql_job_store.h"
#include "services/coordinator/store/jobs/sql_profile_store.h"
#include "services/coordinator/store/jobs/sql_webhook_store.h"
#include "services/coordinator/store/sql/postgres_database.h"
#include "services/coordinator/store/sql/sqlite_database.h"

namespace slicefarm::coordinator {
namespace {

absl::StatusOr<Stores> OpenDirectory(const std::string& directory) {
  if (absl::Status made = MakeDirectory(directory); !made.ok()) return made;
  auto lock = StateLock::Take(directory);
  if (!lock.ok()) return lock.status();
  auto opened = SqliteDatabase::Open(directory + "/jobs.db");
  if (!opened.ok()) return opened.status();
  const std::shared_ptr<SqlDatabase> database = *std::move(opened);
  auto blobs = OpenDirectoryBlobs(directory);
  if (!blobs.ok()) return blobs.status();
  return Stores{.lock = *std::move(lock),
                .jobs = std::make_unique<SqlJobStore>(database),
                .runs = std::make_unique<SqlJobStore>(database),
                .blobs = *std::move(blobs),
                .run_blobs = nullptr,
                .profiles = std::make_unique<SqlProfileStore>(database),
                .webhooks = std::make_unique<SqlWebhookStore>(database),
                .fill = nullptr};
}

/// Runs and blobs have connections of their own, so that neither callers nor transfers keep jobs
/// waiting; each run has one for its blobs, which it may hold for as long as a large result takes.
absl::StatusOr<Stores> OpenPostgres(const std::string& conninfo, int runs) {
  auto opened = PostgresDatabase::Open(conninfo);
  if (!opened.ok()) return opened.status();
  const std::shared_ptr<PostgresDatabase> database = *std::move(opened);
  return Stores{.lock = nullptr,
                .jobs = std::make_unique<SqlJobStore>(database),
                .runs = std::make_unique<SqlJobStore>(database->More()),
                .blobs = MakePostgresBlobs(database->More()),
                .run_blobs = MakePostgresBlobs(database->More(runs)),
                .profiles = std::make_unique<SqlProfileStore>(database),
                .webhooks = std::make_unique<SqlWebhookStore>(database),
                .fill = [database] { return FillOf(*database); }};
}

}  // namespace

absl::StatusOr<Stores> OpenStores(const StoreOptions& options, int runs) {
  return options.postgres.empty() ? OpenDirectory(options.state_dir)
                                  : OpenPostgres(options.postgres, runs);
}

std::unique_ptr<JobChanges> ListenForChanges(const StoreOptions& options,
                                             JobChanges::Listener listener) {
  if (options.postgres.empty()) return nullptr;
  return std::make_unique<PostgresJobChanges>(options.postgres, std::move(listener));
}

}  // namespace slicefarm::coordinator
