#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "services/coordinator/store/sql/sqlite_connection.h"

namespace slicefarm::coordinator {

/// A database in one file, for one machine. Writes go over one connection and reads over some
/// others, so that no reader waits for a writer's fsync, or for a list over a million rows.
class SqliteDatabase : public SqlDatabase {
 public:
  /// Opens or creates the database, checks its pages, and brings it to the present schema. What can
  /// be read then survives a power cut, whatever happened to those who wrote it. Errors:
  /// FailedPrecondition for a damaged file and for the schema of a newer build; STORE_FAILED. Cost:
  /// reads all of the file.
  static absl::StatusOr<std::unique_ptr<SqliteDatabase>> Open(const std::string& path);

  static constexpr int kReaders = 4;

  /// Errors: also STORE_FAILED if all readers are busy for long.
  absl::StatusOr<SqlSession> Read() override;
  absl::StatusOr<SqlSession> Write() override;

 private:
  using Connection = std::unique_ptr<SqliteConnection>;

  SqliteDatabase(std::string path, Connection writer)
      : path_(std::move(path)), writer_(std::move(writer)) {}
  void GiveBack(Connection reader);

  const std::string path_;
  std::mutex write_mutex_;
  const Connection writer_;

  std::mutex read_mutex_;
  std::condition_variable given_back_;
  int free_ = kReaders;  ///< how many more may be taken
  std::vector<Connection> idle_;
};

}  // namespace slicefarm::coordinator
