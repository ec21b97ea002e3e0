#include "services/coordinator/store/sql/sqlite_database.h"

#include <utility>

#include "services/coordinator/store/blobs/posix_file.h"
#include "services/coordinator/store/sql/sqlite_schema.h"

namespace slicefarm::coordinator {
namespace {

/// Puts the log on disk as it is read now: its end may have been written by an earlier life that
/// ended before its fsync, or whose fsync failed. Before all else, so that no page goes into the
/// database that the log might not have after a power cut.
absl::Status SettleLog(SqliteConnection& db, const std::string& path) {
  SqlTransaction transaction(db);  // nobody else writes to it meanwhile
  if (!transaction.status().ok()) return transaction.status();
  const auto log = PosixFile::OpenToWrite(path + "-wal");
  if (!log.ok()) return log.status();
  if (absl::Status synced = log->SyncAnew(); !synced.ok()) return synced;
  if (absl::Status synced = SyncDirectory(ParentOf(path)); !synced.ok()) return synced;
  return transaction.Commit();
}

}  // namespace

absl::StatusOr<std::unique_ptr<SqliteDatabase>> SqliteDatabase::Open(const std::string& path) {
  auto writer = SqliteConnection::Open(path);
  if (!writer.ok()) return writer.status();
  if (absl::Status settled = SettleLog(**writer, path); !settled.ok()) return settled;
  if (absl::Status ready = MigrateSqlite(**writer); !ready.ok()) return ready;
  auto reader = SqliteConnection::Open(path);
  if (!reader.ok()) return reader.status();
  return std::unique_ptr<SqliteDatabase>(
      new SqliteDatabase(*std::move(writer), *std::move(reader)));
}

SqlSession SqliteDatabase::Take(std::mutex& mutex, SqlConnection& connection) {
  mutex.lock();
  return SqlSession(&connection, [&mutex](SqlConnection*) { mutex.unlock(); });
}

}  // namespace slicefarm::coordinator
