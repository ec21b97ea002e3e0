#include "services/coordinator/server/main/stores.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "services/coordinator/store/disk/posix_file.h"
#include "services/coordinator/store/jobs/postgres_job_changes.h"
#include "services/coordinator/store/jobs/sql_job_store.h"
#include "services/coordinator/store/jobs/sql_profile_store.h"
#include "services/coordinator/store/jobs/sql_webhook_store.h"
#include "services/coordinator/store/s3/s3_blobs.h"
#include "services/coordinator/store/sql/postgres_database.h"
#include "services/coordinator/store/sql/sqlite_database.h"

namespace slicefarm::coordinator {
namespace {

/// Returns stores with the blobs in the bucket. Uploads in progress stay in `staged`. Without a
/// bucket, returns `staged`.
std::unique_ptr<BlobStores> InBucket(const StoreOptions& options,
                                     std::shared_ptr<SqlDatabase> database,
                                     std::unique_ptr<BlobStores> staged) {
  if (options.s3 == nullptr) return staged;
  return std::make_unique<S3Blobs>(options.s3, std::move(database), std::move(staged));
}

/// Checks the bucket at the start, so that an error is reported once and not for each job.
absl::Status CheckBucket(const StoreOptions& options) {
  if (options.s3 == nullptr) return absl::OkStatus();
  const absl::Status usable = options.s3->Probe();
  if (usable.ok()) return usable;
  const std::string why = absl::StrCat("S3: ", usable.message());
  if (absl::IsUnavailable(usable)) return StoreAway(why);
  return MakeError(absl::StatusCode::kFailedPrecondition, Reason::kStoreFailed, why);
}

/// Returns FailedPrecondition if the directory has blobs, but no database with their records. A new
/// database would treat them as blobs without a job, and the sweep would delete them.
absl::Status CheckDatabaseOfBlobs(const std::string& directory) {
  const std::string path = directory + "/jobs.db";
  std::error_code missing;
  if (const auto size = std::filesystem::file_size(path, missing); !missing && size > 0)
    return absl::OkStatus();
  const auto has_blobs = HasDirectoryBlobs(directory);
  if (!has_blobs.ok()) return has_blobs.status();
  if (!*has_blobs) return absl::OkStatus();
  return MakeError(
      absl::StatusCode::kFailedPrecondition, Reason::kStoreFailed,
      absl::StrCat(path, missing ? " is missing" : " is empty", ", but ", directory,
                   " has models and results: mount the right directory or restore the database; "
                   "for a new farm, move them away"));
}

absl::StatusOr<Stores> OpenDirectory(const StoreOptions& options) {
  const std::string& directory = options.state_dir;
  if (absl::Status made = MakeDirectory(directory); !made.ok()) return made;
  auto lock = StateLock::Take(directory);
  if (!lock.ok()) return lock.status();
  if (absl::Status known = CheckDatabaseOfBlobs(directory); !known.ok()) return known;
  auto opened = SqliteDatabase::Open(directory + "/jobs.db");
  if (!opened.ok()) return opened.status();
  const std::shared_ptr<SqlDatabase> database = *std::move(opened);
  auto blobs = OpenDirectoryBlobs(directory);
  if (!blobs.ok()) return blobs.status();
  return Stores{.lock = *std::move(lock),
                .jobs = std::make_unique<SqlJobStore>(database),
                .runs = std::make_unique<SqlJobStore>(database),
                .blobs = InBucket(options, database, *std::move(blobs)),
                .run_blobs = nullptr,
                .profiles = std::make_unique<SqlProfileStore>(database),
                .preset_bundles = std::make_unique<SqlProfileStore>(database, kPresetTable),
                .webhooks = std::make_unique<SqlWebhookStore>(database),
                .fill = nullptr,
                .answers = nullptr};
}

/// Opens the stores in PostgreSQL. Runs and blobs have connections of their own, so that neither
/// callers nor transfers delay jobs. Each run has one connection for its blobs, because a large
/// result may occupy it for long.
absl::StatusOr<Stores> OpenPostgres(const StoreOptions& options, int runs) {
  auto opened = PostgresDatabase::Open(options.postgres);
  if (!opened.ok()) return opened.status();
  const std::shared_ptr<PostgresDatabase> database = *std::move(opened);
  auto begun = PostgresPulse::Begin(options.postgres, options.name);
  if (!begun.ok()) return begun.status();
  const std::shared_ptr<const PostgresPulse> pulse = *std::move(begun);
  database->Heed(pulse);
  const std::shared_ptr<SqlDatabase> of_transfers = database->More();
  const std::shared_ptr<SqlDatabase> of_runs = database->More(runs);
  return Stores{.lock = nullptr,
                .jobs = std::make_unique<SqlJobStore>(database),
                .runs = std::make_unique<SqlJobStore>(database->More()),
                .blobs = InBucket(options, of_transfers, MakePostgresBlobs(of_transfers)),
                .run_blobs = InBucket(options, of_runs, MakePostgresBlobs(of_runs)),
                .profiles = std::make_unique<SqlProfileStore>(database),
                .preset_bundles = std::make_unique<SqlProfileStore>(database, kPresetTable),
                .webhooks = std::make_unique<SqlWebhookStore>(database),
                .fill = [database] { return FillOf(*database); },
                .answers = [pulse] { return !pulse->silent(); }};
}

}  // namespace

absl::StatusOr<Stores> OpenStores(const StoreOptions& options, int runs) {
  if (absl::Status usable = CheckBucket(options); !usable.ok()) return usable;
  return options.postgres.empty() ? OpenDirectory(options) : OpenPostgres(options, runs);
}

std::unique_ptr<JobChanges> ListenForChanges(const StoreOptions& options,
                                             JobChanges::Listener listener) {
  if (options.postgres.empty()) return nullptr;
  return std::make_unique<PostgresJobChanges>(options.postgres, std::move(listener));
}

}  // namespace slicefarm::coordinator
