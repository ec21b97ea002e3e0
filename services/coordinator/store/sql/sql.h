#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm::coordinator {

/// What SqlJobStore needs of a database: SQLite's and PostgreSQL's common part. Statements are
/// written once for both, with `?` for parameters.

/// Where the two differ.
struct SqlDialect {
  std::string_view begin;        ///< a transaction that will write
  std::string_view for_update;   ///< after a SELECT of rows that the transaction will write
  std::string_view skip_locked;  ///< the same, passing over rows that another one holds
  std::string_view lock_tenant;  ///< until the transaction ends; empty: no other one writes
  std::string_view lock_work;    ///< the same, by an action digest
  std::string_view notify;       ///< tells other processes of jobs; empty: there are none
  std::string_view spec;         ///< of the row of `jobs` that is selected, be it in it or apart
  std::string_view texts;        ///< the strings of a JSON list, as a table with the column `value`
  bool writes_in_with;           ///< what stands in WITH may write
  bool names_indexes;            ///< its planner knows no statistics, and needs to be told

  /// After the name of a table, the index by which it is to be read.
  std::string Through(std::string_view index) const {
    return names_indexes ? " INDEXED BY " + std::string(index) : std::string();
  }
};

/// STORE_FAILED as Unavailable: it may go better a second later, and says so.
absl::Status StoreAway(std::string_view why);

/// Bytes that are no text.
struct Blob {
  std::string_view bytes;
};

/// One run of a statement. The first error sticks: rows end, and status() tells.
class SqlStatement {
 public:
  virtual ~SqlStatement() = default;
  virtual void Bind(int64_t value) = 0;
  virtual void Bind(std::string_view value) = 0;
  virtual void Bind(Blob value) = 0;
  /// To the next row; false: there is none.
  virtual bool Next() = 0;
  virtual const absl::Status& status() const = 0;
  virtual int64_t Int(int column) const = 0;       ///< of a truth value: 0 or 1
  virtual std::string Text(int column) const = 0;  ///< of a blob: its bytes
};

/// Statements that a connection keeps. Those of lists have their filters' shapes, which are many.
inline constexpr size_t kMostPrepared = 128;

/// One connection. Not thread-safe: a user at a time.
class SqlConnection {
 public:
  virtual ~SqlConnection() = default;
  virtual const SqlDialect& dialect() const = 0;
  /// Runs statements without parameters or results.
  virtual absl::Status Execute(const std::string& sql) = 0;
  /// `sql` is prepared once a connection, the first kMostPrepared are; no two runs of the same text
  /// at a time.
  virtual std::unique_ptr<SqlStatement> Prepare(std::string_view sql) = 0;
};

/// A statement with its parameters:
///
///   SqlQuery query(db, "SELECT id FROM jobs WHERE state = ?");
///   query.Bind("QUEUED");
///   while (query.Next()) ids.push_back(query.Text(0));
///   if (!query.status().ok()) return query.status();
class SqlQuery {
 public:
  SqlQuery(SqlConnection& connection, std::string_view sql) : statement_(connection.Prepare(sql)) {}

  template <typename... Values>
  SqlQuery& Bind(const Values&... values) {
    (BindNext(values), ...);
    return *this;
  }

  bool Next() { return statement_->Next(); }
  /// To the end, for statements without rows.
  absl::Status Run();
  const absl::Status& status() const { return statement_->status(); }
  int64_t Int(int column) const { return statement_->Int(column); }
  std::string Text(int column) const { return statement_->Text(column); }

 private:
  void BindNext(int64_t value) { statement_->Bind(value); }
  void BindNext(int32_t value) { statement_->Bind(int64_t{value}); }
  void BindNext(bool value) { statement_->Bind(int64_t{value}); }
  void BindNext(std::string_view value) { statement_->Bind(value); }
  void BindNext(const std::string& value) { statement_->Bind(std::string_view(value)); }
  void BindNext(const char* value) { statement_->Bind(std::string_view(value)); }
  void BindNext(Blob value) { statement_->Bind(value); }

  std::unique_ptr<SqlStatement> statement_;
};

/// A write transaction. Rolled back unless committed.
class SqlTransaction {
 public:
  explicit SqlTransaction(SqlConnection& connection);
  ~SqlTransaction();
  SqlTransaction(const SqlTransaction&) = delete;
  SqlTransaction& operator=(const SqlTransaction&) = delete;

  const absl::Status& status() const { return status_; }
  absl::Status Commit();

 private:
  SqlConnection& connection_;
  absl::Status status_;
  bool open_ = false;
};

/// A connection of a database, until it is given back.
using SqlSession = std::unique_ptr<SqlConnection, std::function<void(SqlConnection*)>>;

/// Thread-safe.
class SqlDatabase {
 public:
  virtual ~SqlDatabase() = default;
  /// Waits for a free connection. Errors: STORE_FAILED if none can be made.
  virtual absl::StatusOr<SqlSession> Read() = 0;
  virtual absl::StatusOr<SqlSession> Write() = 0;
};

}  // namespace slicefarm::coordinator
