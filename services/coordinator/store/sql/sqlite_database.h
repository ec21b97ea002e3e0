#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "services/coordinator/store/sql/sqlite_connection.h"

namespace slicefarm::coordinator {

/// A database in one file, for one machine. Writes go over one connection and reads over another,
/// so that no reader waits for a writer's fsync.
class SqliteDatabase : public SqlDatabase {
 public:
  /// Opens or creates the database and brings it to the present schema. What can be read then
  /// survives a power cut, whatever happened to those who wrote it.
  static absl::StatusOr<std::unique_ptr<SqliteDatabase>> Open(const std::string& path);

  absl::StatusOr<SqlSession> Read() override { return Take(read_mutex_, *reader_); }
  absl::StatusOr<SqlSession> Write() override { return Take(write_mutex_, *writer_); }

 private:
  SqliteDatabase(std::unique_ptr<SqliteConnection> writer, std::unique_ptr<SqliteConnection> reader)
      : writer_(std::move(writer)), reader_(std::move(reader)) {}

  static SqlSession Take(std::mutex& mutex, SqlConnection& connection);

  std::mutex write_mutex_;
  std::unique_ptr<SqliteConnection> writer_;
  std::mutex read_mutex_;
  std::unique_ptr<SqliteConnection> reader_;
};

}  // namespace slicefarm::coordinator
