#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "services/coordinator/store/sql/sqlite_connection.h"

namespace slicefarm::coordinator {

/// Database in a local file. It has one connection for writing and several for reading. So a reader
/// waits neither for the fsync of a writer nor for another reader that lists a million rows.
class SqliteDatabase : public SqlDatabase {
 public:
  /// Opens or creates the database, checks its pages, and brings it to the schema of this build.
  /// After that, all readable data is on disk and survives a power cut, even if its writer was
  /// killed before the fsync. Errors: FailedPrecondition for a damaged file and for the schema of a
  /// newer build; STORE_FAILED. Cost: reads the whole file.
  static absl::StatusOr<std::unique_ptr<SqliteDatabase>> Open(const std::string& path);

  static constexpr int kReaders = 4;

  /// Returns a connection for reading. Errors: also STORE_FAILED if all readers are busy for long.
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
  int free_ = kReaders;  ///< number of readers that may still be taken
  std::vector<Connection> idle_;
};

}  // namespace slicefarm::coordinator
