#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "services/coordinator/store/sql/sql.h"

struct sqlite3;
struct sqlite3_stmt;

namespace slicefarm::coordinator {

/// Connection to an SQLite database, with its prepared statements.
///
/// Durable: write-ahead log, synchronous=FULL. Waits up to 5 s for another program's lock.
class SqliteConnection : public SqlConnection {
 public:
  /// Opens a database, or creates it. Errors: STORE_FAILED, DISK_FULL.
  static absl::StatusOr<std::unique_ptr<SqliteConnection>> Open(const std::string& path);
  ~SqliteConnection() override;
  SqliteConnection(const SqliteConnection&) = delete;
  SqliteConnection& operator=(const SqliteConnection&) = delete;

  const SqlDialect& dialect() const override;
  absl::Status Execute(const std::string& sql) override;
  std::unique_ptr<SqlStatement> Prepare(std::string_view sql) override;

 private:
  explicit SqliteConnection(sqlite3* db) : db_(db) {}
  absl::StatusOr<sqlite3_stmt*> Compile(std::string_view sql);

  sqlite3* db_;
  std::map<std::string, sqlite3_stmt*, std::less<>> prepared_;
};

}  // namespace slicefarm::coordinator
