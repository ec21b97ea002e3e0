#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm::coordinator {

// Common interface of SQLite and PostgreSQL for SqlJobStore. Statements are written once for both,
// with `?` for parameters.

/// SQL texts and properties in which the two databases differ.
struct SqlDialect {
  std::string_view begin;       ///< begins a transaction that will write
  std::string_view for_update;  ///< ends a SELECT: locks the rows, which the transaction will write
  /// Like for_update, but skips rows that another transaction has locked.
  std::string_view skip_locked;
  /// Statement that locks a tenant until the transaction ends. Empty if only one transaction at a
  /// time can write.
  std::string_view lock_tenant;
  std::string_view lock_work;  ///< like lock_tenant, but locks an action digest
  /// Statement that notifies other coordinators of a change of a job. Empty if the database cannot
  /// be shared.
  std::string_view notify;
  /// Expression for the spec of the selected row of `jobs`. The spec may be in another table.
  std::string_view spec;
  std::string_view texts;  ///< table expression: the strings of a JSON list, in the column `value`
  bool writes_in_with;     ///< true if statements in WITH may write
  /// True if a statement must name its index, because the planner has no statistics.
  bool names_indexes;

  /// Returns the text that follows a table's name and selects the index for reading it.
  std::string Through(std::string_view index) const {
    return names_indexes ? " INDEXED BY " + std::string(index) : std::string();
  }
};

/// Returns the error STORE_FAILED with the code Unavailable and a retry after one second.
absl::Status StoreAway(std::string_view why);

/// Parameter of bytes that are not a text.
struct Blob {
  std::string_view bytes;
};

/// One execution of a statement. After an error, Next() returns false and status() returns this
/// error.
class SqlStatement {
 public:
  virtual ~SqlStatement() = default;
  /// Sets the next parameter to a number.
  virtual void Bind(int64_t value) = 0;
  /// Sets the next parameter to a text.
  virtual void Bind(std::string_view value) = 0;
  /// Sets the next parameter to bytes.
  virtual void Bind(Blob value) = 0;
  /// Moves to the next row. Returns false if there is none.
  virtual bool Next() = 0;
  /// Returns the first error.
  virtual const absl::Status& status() const = 0;
  virtual int64_t Int(int column) const = 0;       ///< integer column; 0 or 1 for a truth value
  virtual std::string Text(int column) const = 0;  ///< text column, or the bytes of a blob
};

/// Largest number of prepared statements of a connection. The number is limited because the
/// statements for lists have many forms, one per combination of filters.
inline constexpr size_t kMostPrepared = 128;

/// Connection to a database. Not thread-safe: only one user at a time.
class SqlConnection {
 public:
  virtual ~SqlConnection() = default;
  /// Returns the dialect of the database.
  virtual const SqlDialect& dialect() const = 0;
  /// Runs statements without parameters and results.
  virtual absl::Status Execute(const std::string& sql) = 0;
  /// Starts an execution of `sql`. The first kMostPrepared different statements of a connection are
  /// prepared once. REQUIRES: no other execution of the same text is in progress.
  virtual std::unique_ptr<SqlStatement> Prepare(std::string_view sql) = 0;
};

/// Statement with its parameters:
///
///   SqlQuery query(db, "SELECT id FROM jobs WHERE state = ?");
///   query.Bind("QUEUED");
///   while (query.Next()) ids.push_back(query.Text(0));
///   if (!query.status().ok()) return query.status();
class SqlQuery {
 public:
  SqlQuery(SqlConnection& connection, std::string_view sql) : statement_(connection.Prepare(sql)) {}

  template <typename... Values>
  /// Sets the next parameters.
  SqlQuery& Bind(const Values&... values) {
    (BindNext(values), ...);
    return *this;
  }

  /// Moves to the next row. Returns false if there is none.
  bool Next() { return statement_->Next(); }
  /// Runs the statement to its end, for statements without rows.
  absl::Status Run();
  /// Returns the first error.
  const absl::Status& status() const { return statement_->status(); }
  /// Returns a column of the current row as a number.
  int64_t Int(int column) const { return statement_->Int(column); }
  /// Returns a column of the current row as a text.
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

/// Write transaction. The destructor rolls it back unless it was committed.
class SqlTransaction {
 public:
  explicit SqlTransaction(SqlConnection& connection);
  ~SqlTransaction();
  SqlTransaction(const SqlTransaction&) = delete;
  SqlTransaction& operator=(const SqlTransaction&) = delete;

  /// Returns the status of the BEGIN statement.
  const absl::Status& status() const { return status_; }
  /// Commits the transaction.
  absl::Status Commit();

 private:
  SqlConnection& connection_;
  absl::Status status_;
  bool open_ = false;
};

/// Connection that was taken from a database. The destructor returns it to the database.
using SqlSession = std::unique_ptr<SqlConnection, std::function<void(SqlConnection*)>>;

/// Database that provides connections. Thread-safe.
class SqlDatabase {
 public:
  virtual ~SqlDatabase() = default;
  /// Waits for a free connection for reading. Errors: STORE_FAILED if none can be opened.
  virtual absl::StatusOr<SqlSession> Read() = 0;
  /// Waits for a free connection for writing. Errors: STORE_FAILED if none can be opened.
  virtual absl::StatusOr<SqlSession> Write() = 0;
};

}  // namespace slicefarm::coordinator
