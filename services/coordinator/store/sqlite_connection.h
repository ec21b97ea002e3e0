#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

struct sqlite3;
struct sqlite3_stmt;

namespace slicefarm::coordinator {

/// One connection to an SQLite database, with its prepared statements. Not thread-safe: a user at a
/// time.
///
/// Durable: write-ahead log, synchronous=FULL. Waits up to 5 s for another process's lock.
class SqliteConnection {
 public:
  /// Opens or creates. Errors: STORE_FAILED, DISK_FULL.
  static absl::StatusOr<std::unique_ptr<SqliteConnection>> Open(const std::string& path);
  ~SqliteConnection();
  SqliteConnection(const SqliteConnection&) = delete;
  SqliteConnection& operator=(const SqliteConnection&) = delete;

  /// Runs statements without parameters or results.
  absl::Status Execute(const std::string& sql);

  /// DISK_FULL, or STORE_FAILED with SQLite's words.
  absl::Status Error(int code) const;

 private:
  friend class SqliteQuery;
  explicit SqliteConnection(sqlite3* db) : db_(db) {}
  absl::StatusOr<sqlite3_stmt*> Prepare(std::string_view sql);

  sqlite3* db_;
  std::map<std::string, sqlite3_stmt*, std::less<>> prepared_;
};

/// Bytes that are no text.
struct Blob {
  std::string_view bytes;
};

/// One run of a statement. The first error sticks: rows end, and status() tells.
///
///   SqliteQuery query(db, "SELECT id FROM jobs WHERE state = ?");
///   query.Bind("QUEUED");
///   while (query.Next()) ids.push_back(query.Text(0));
///   if (!query.status().ok()) return query.status();
class SqliteQuery {
 public:
  /// `sql` is prepared once a connection; no two runs of the same text at a time.
  SqliteQuery(SqliteConnection& connection, std::string_view sql);
  ~SqliteQuery();
  SqliteQuery(const SqliteQuery&) = delete;
  SqliteQuery& operator=(const SqliteQuery&) = delete;

  template <typename... Values>
  SqliteQuery& Bind(const Values&... values) {
    (BindNext(values), ...);
    return *this;
  }

  bool Next();
  /// To the end, for statements without rows.
  absl::Status Run();
  const absl::Status& status() const { return status_; }

  int64_t Int(int column) const;
  std::string Text(int column) const;  ///< of a blob: its bytes

 private:
  void BindNext(int64_t value);
  void BindNext(int32_t value) { BindNext(int64_t{value}); }
  void BindNext(bool value) { BindNext(int64_t{value}); }
  void BindNext(std::string_view value);
  void BindNext(Blob value);
  void BindNext(const std::string& value) { BindNext(std::string_view(value)); }
  void BindNext(const char* value) { BindNext(std::string_view(value)); }
  void Check(int code);

  SqliteConnection& connection_;
  sqlite3_stmt* statement_ = nullptr;
  int bound_ = 0;
  absl::Status status_;
};

/// A write transaction: from its birth no other connection writes. Rolled back unless committed.
class SqliteTransaction {
 public:
  explicit SqliteTransaction(SqliteConnection& connection);
  ~SqliteTransaction();
  SqliteTransaction(const SqliteTransaction&) = delete;
  SqliteTransaction& operator=(const SqliteTransaction&) = delete;

  const absl::Status& status() const { return status_; }
  absl::Status Commit();

 private:
  SqliteConnection& connection_;
  absl::Status status_;
  bool open_ = false;
};

}  // namespace slicefarm::coordinator
