#include "services/coordinator/server/main/move_blobs.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "services/coordinator/server/main/s3_flags.h"
#include "services/coordinator/server/main/state_lock.h"
#include "services/coordinator/server/main/stores.h"
#include "services/coordinator/store/s3/s3_blobs.h"
#include "services/coordinator/store/sql/postgres_database.h"
#include "services/coordinator/store/sql/sqlite_database.h"

namespace slicefarm::coordinator {
namespace {

/// Number of moved blobs between two lines of output.
constexpr int64_t kBlobsPerReport = 1'000;

/// Source of the blobs.
struct Source {
  std::unique_ptr<StateLock> lock;  ///< lock of a state directory
  std::shared_ptr<SqlDatabase> database;
  std::unique_ptr<BlobStores> blobs;
};

absl::StatusOr<Source> OpenSource(const StoreOptions& from) {
  if (!from.postgres.empty()) {
    auto opened = PostgresDatabase::Open(from.postgres);
    if (!opened.ok()) return opened.status();
    const std::shared_ptr<SqlDatabase> database = *std::move(opened);
    return Source{nullptr, database, MakePostgresBlobs(database)};
  }
  auto lock = StateLock::Take(from.state_dir);
  if (!lock.ok()) return lock.status();
  auto database = SqliteDatabase::Open(from.state_dir + "/jobs.db");
  if (!database.ok()) return database.status();
  auto blobs = OpenDirectoryBlobs(from.state_dir);
  if (!blobs.ok()) return blobs.status();
  return Source{*std::move(lock), *std::move(database), *std::move(blobs)};
}

absl::Status Move(const StoreOptions& from, const S3Flags& to) {
  const auto credentials = to.credentials_file.empty() ? S3CredentialsOfEnvironment()
                                                       : ReadS3Credentials(to.credentials_file);
  if (!credentials.ok()) return credentials.status();
  const auto shared = std::make_shared<const S3Credentials>(*credentials);
  const auto bucket = MakeS3Client(to, [shared] { return shared; });
  if (!bucket.ok()) return bucket.status();
  if (absl::Status usable = (*bucket)->Probe(); !usable.ok()) return usable;
  auto source = OpenSource(from);
  if (!source.ok()) return source.status();
  S3Blobs blobs(*bucket, source->database, std::move(source->blobs));
  int64_t count = 0;
  int64_t bytes = 0;
  const auto report = [&] {
    fmt::print("moved {} blobs, {} bytes\n", count, bytes);
    std::fflush(stdout);
  };
  absl::Status moved_all = blobs.MoveStaged([&](const BlobEntry& blob) {
    bytes += blob.size;
    if (++count % kBlobsPerReport == 0) report();
  });
  report();
  return moved_all;
}

}  // namespace

int MoveBlobs(int argc, char** argv) {
  CLI::App app(
      "slicefarm-coordinator move-blobs: moves blobs from a database or a directory into a bucket");
  StoreOptions from;
  S3Flags to;
  auto* const postgres =
      app.add_option("--postgres", from.postgres, "Connection string of the database to move from");
  auto* const directory =
      app.add_option("--state-dir", from.state_dir,
                     "State directory to move from; its coordinator must not run meanwhile")
          ->check(CLI::ExistingDirectory)
          ->excludes(postgres);
  AddS3Flags(app, &to);
  app.get_option("--s3")->required();
  app.callback([&] {
    if (postgres->empty() && directory->empty())
      throw CLI::ValidationError("one of --state-dir and --postgres is needed");
  });
  CLI11_PARSE(app, argc, argv);
  const absl::Status moved = Move(from, to);
  if (moved.ok()) return 0;
  fmt::print(stderr, "slicefarm-coordinator move-blobs: {}\n", std::string(moved.message()));
  return 1;
}

}  // namespace slicefarm::coordinator
