#include "services/coordinator/server/stores.h"

#include <utility>

#include "services/coordinator/store/posix_file.h"
#include "services/coordinator/store/postgres_database.h"
#include "services/coordinator/store/postgres_job_changes.h"
#include "services/coordinator/store/sql_job_store.h"

namespace slicefarm::coordinator {
namespace {

absl::StatusOr<Stores> OpenDirectory(const std::string& directory) {
  if (absl::Status made = MakeDirectory(directory); !made.ok()) return made;
  auto lock = StateLock::Take(directory);
  if (!lock.ok()) return lock.status();
  auto jobs = OpenSqliteJobStore(directory + "/jobs.db");
  if (!jobs.ok()) return jobs.status();
  auto blobs = OpenDirectoryBlobs(directory);
  if (!blobs.ok()) return blobs.status();
  return Stores{*std::move(lock), *std::move(jobs), *std::move(blobs)};
}

/// Blobs have connections of their own, so that no transfer keeps jobs waiting.
absl::StatusOr<Stores> OpenPostgres(const std::string& conninfo) {
  auto jobs = PostgresDatabase::Open(conninfo);
  if (!jobs.ok()) return jobs.status();
  auto blobs = PostgresDatabase::Open(conninfo);
  if (!blobs.ok()) return blobs.status();
  return Stores{nullptr, std::make_unique<SqlJobStore>(*std::move(jobs)),
                MakePostgresBlobs(*std::move(blobs))};
}

}  // namespace

absl::StatusOr<Stores> OpenStores(const StoreOptions& options) {
  return options.postgres.empty() ? OpenDirectory(options.state_dir)
                                  : OpenPostgres(options.postgres);
}

std::unique_ptr<JobChanges> ListenForChanges(const StoreOptions& options,
                                             JobChanges::Listener listener) {
  if (options.postgres.empty()) return nullptr;
  return std::make_unique<PostgresJobChanges>(options.postgres, std::move(listener));
}

}  // namespace slicefarm::coordinator
