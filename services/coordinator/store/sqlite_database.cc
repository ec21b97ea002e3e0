#include "services/coordinator/store/sqlite_database.h"

#include <utility>

#include "services/coordinator/store/sqlite_schema.h"

namespace slicefarm::coordinator {

absl::StatusOr<std::unique_ptr<SqliteDatabase>> SqliteDatabase::Open(const std::string& path) {
  auto writer = SqliteConnection::Open(path);
  if (!writer.ok()) return writer.status();
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
