#include "services/coordinator/store/sql/sqlite_database.h"

#include <chrono>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "services/coordinator/store/disk/posix_file.h"
#include "services/coordinator/store/sql/sqlite_schema.h"

namespace slicefarm::coordinator {
namespace {

/// Longest wait for a reader. It is shorter than a lease, so that the renewal of a lease gets the
/// error in time.
constexpr std::chrono::seconds kReaderPatience{5};

/// Writes the log to disk in its current state. The previous run of the program may have written
/// the end of the log without a successful fsync. This is done before all other steps, so that no
/// page is copied into the database that the log may lose in a power cut.
absl::Status SettleLog(SqliteConnection& db, const std::string& path) {
  SqlTransaction transaction(db);  // no other connection writes meanwhile
  if (!transaction.status().ok()) return transaction.status();
  const auto log = PosixFile::OpenToWrite(path + "-wal");
  if (!log.ok()) return log.status();
  if (absl::Status synced = log->SyncAnew(); !synced.ok()) return synced;
  if (absl::Status synced = SyncDirectory(ParentOf(path)); !synced.ok()) return synced;
  return transaction.Commit();
}

/// Returns FailedPrecondition if pages of the database are damaged. Cost: reads the whole database.
absl::Status CheckIntegrity(SqliteConnection& db, const std::string& path) {
  SqlQuery check(db, "PRAGMA quick_check(1)");
  std::string found;
  while (check.Next()) found = check.Text(0);
  if (!check.status().ok()) found = std::string(check.status().message());
  if (found == "ok") return absl::OkStatus();
  return MakeError(
      absl::StatusCode::kFailedPrecondition, Reason::kStoreFailed,
      absl::StrCat(path, " is damaged: ", found, "; restore it from a backup (deploy/restore.sh)"));
}

}  // namespace

absl::StatusOr<std::unique_ptr<SqliteDatabase>> SqliteDatabase::Open(const std::string& path) {
  auto writer = SqliteConnection::Open(path);
  if (!writer.ok()) return writer.status();
  if (absl::Status settled = SettleLog(**writer, path); !settled.ok()) return settled;
  if (absl::Status intact = CheckIntegrity(**writer, path); !intact.ok()) return intact;
  if (absl::Status ready = MigrateSqlite(**writer); !ready.ok()) return ready;
  std::unique_ptr<SqliteDatabase> database(new SqliteDatabase(path, *std::move(writer)));
  // An unreadable database is reported at once.
  if (const auto readable = database->Read(); !readable.ok()) return readable.status();
  return database;
}

absl::StatusOr<SqlSession> SqliteDatabase::Write() {
  write_mutex_.lock();
  return SqlSession(writer_.get(), [this](SqlConnection*) { write_mutex_.unlock(); });
}

absl::StatusOr<SqlSession> SqliteDatabase::Read() {
  Connection reader;
  {
    std::unique_lock lock(read_mutex_);
    if (!given_back_.wait_for(lock, kReaderPatience, [this] { return free_ > 0; }))
      return StoreAway("SQLite: all readers are busy");
    --free_;
    if (!idle_.empty()) {
      reader = std::move(idle_.back());
      idle_.pop_back();
    }
  }
  if (!reader) {
    auto opened = SqliteConnection::Open(path_);
    if (!opened.ok()) {
      GiveBack(nullptr);
      return opened.status();
    }
    reader = *std::move(opened);
  }
  return SqlSession(reader.release(), [this](SqlConnection* used) {
    GiveBack(Connection(static_cast<SqliteConnection*>(used)));
  });
}

void SqliteDatabase::GiveBack(Connection reader) {
  const std::lock_guard lock(read_mutex_);
  if (reader) idle_.push_back(std::move(reader));
  ++free_;
  given_back_.notify_one();
}

}  // namespace slicefarm::coordinator
