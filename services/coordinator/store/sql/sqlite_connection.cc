#include "services/coordinator/store/sql/sqlite_connection.h"

#include <sqlite3.h>

#include <cerrno>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"

namespace slicefarm::coordinator {
namespace {

constexpr int kBusyTimeoutMs = 5000;
/// A transaction blocks all other writers from its first statement (BEGIN IMMEDIATE) on, so no
/// other locks are needed.
constexpr SqlDialect kSqliteDialect = {
    .begin = "BEGIN IMMEDIATE",
    .for_update = "",
    .skip_locked = "",
    .lock_tenant = "",
    .lock_work = "",
    .notify = "",
    .spec = "(SELECT spec FROM specs WHERE job = number)",
    .texts = "json_each(?)",
    .writes_in_with = false,
    .names_indexes = true,
};

/// Returns true if a file of the database had no space. SQLite reports most such cases as I/O
/// errors.
bool IsDiskFull(sqlite3* db, int code) {
  if (code == SQLITE_FULL) return true;
  if (code != SQLITE_IOERR && code != SQLITE_CANTOPEN) return false;
  const int error = sqlite3_system_errno(db);
  return error == ENOSPC || error == EDQUOT;
}

/// Returns DISK_FULL, or STORE_FAILED with SQLite's message.
absl::Status ErrorOf(sqlite3* db, int code) {
  if (code == SQLITE_OK) return absl::OkStatus();
  const std::string message = absl::StrCat("SQLite: ", sqlite3_errmsg(db));
  if (IsDiskFull(db, code & 0xff)) {
    return MakeError(absl::StatusCode::kResourceExhausted, Reason::kDiskFull, message);
  }
  switch (code & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return StoreAway(message);
    default:
      return MakeError(absl::StatusCode::kInternal, Reason::kStoreFailed, message);
  }
}

class SqliteStatement : public SqlStatement {
 public:
  enum class Of { kConnection, kItself };

  SqliteStatement(sqlite3* db, absl::StatusOr<sqlite3_stmt*> statement, Of owner)
      : db_(db),
        statement_(statement.ok() ? *statement : nullptr),
        owner_(owner),
        status_(statement.status()) {}
  ~SqliteStatement() override {
    if (statement_ == nullptr) return;
    if (owner_ == Of::kItself) {
      sqlite3_finalize(statement_);
      return;
    }
    sqlite3_reset(statement_);
    sqlite3_clear_bindings(statement_);
  }
  SqliteStatement(const SqliteStatement&) = delete;
  SqliteStatement& operator=(const SqliteStatement&) = delete;

  void Bind(int64_t value) override {
    if (status_.ok()) Check(sqlite3_bind_int64(statement_, ++bound_, value));
  }
  void Bind(std::string_view value) override {
    if (!status_.ok()) return;
    Check(sqlite3_bind_text64(statement_, ++bound_, value.data(), value.size(), SQLITE_TRANSIENT,
                              SQLITE_UTF8));
  }
  void Bind(Blob value) override {
    if (!status_.ok()) return;
    Check(sqlite3_bind_blob64(statement_, ++bound_, value.bytes.data(), value.bytes.size(),
                              SQLITE_TRANSIENT));
  }

  bool Next() override {
    if (!status_.ok()) return false;
    const int code = sqlite3_step(statement_);
    if (code == SQLITE_ROW) return true;
    if (code != SQLITE_DONE) Check(code);
    return false;
  }
  const absl::Status& status() const override { return status_; }

  int64_t Int(int column) const override { return sqlite3_column_int64(statement_, column); }
  std::string Text(int column) const override {
    const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement_, column));
    return std::string(bytes == nullptr ? "" : bytes, sqlite3_column_bytes(statement_, column));
  }

 private:
  void Check(int code) {
    if (code != SQLITE_OK && status_.ok()) status_ = ErrorOf(db_, code);
  }

  sqlite3* db_;
  sqlite3_stmt* statement_;
  const Of owner_;
  int bound_ = 0;
  absl::Status status_;
};

}  // namespace

absl::StatusOr<std::unique_ptr<SqliteConnection>> SqliteConnection::Open(const std::string& path) {
  sqlite3* db = nullptr;
  const int code = sqlite3_open_v2(
      path.c_str(), &db, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX, nullptr);
  std::unique_ptr<SqliteConnection> connection(new SqliteConnection(db));
  if (code != SQLITE_OK) return ErrorOf(db, code);
  // SQLite opens a file without write permission as read-only
  if (sqlite3_db_readonly(db, "main") == 1) {
    return MakeError(absl::StatusCode::kInternal, Reason::kStoreFailed,
                     absl::StrCat("SQLite: ", path, " cannot be written"));
  }
  sqlite3_extended_result_codes(db, 1);
  sqlite3_busy_timeout(db, kBusyTimeoutMs);
  const absl::Status ready = connection->Execute(
      "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON;"
      "PRAGMA cache_size = -32768;");  // KiB
  if (!ready.ok()) return ready;
  return connection;
}

SqliteConnection::~SqliteConnection() {
  for (const auto& [sql, statement] : prepared_) sqlite3_finalize(statement);
  sqlite3_close(db_);
}

const SqlDialect& SqliteConnection::dialect() const { return kSqliteDialect; }

absl::Status SqliteConnection::Execute(const std::string& sql) {
  return ErrorOf(db_, sqlite3_exec(db_, sql.c_str(), nullptr, nullptr, nullptr));
}

std::unique_ptr<SqlStatement> SqliteConnection::Prepare(std::string_view sql) {
  if (const auto found = prepared_.find(sql); found != prepared_.end()) {
    return std::make_unique<SqliteStatement>(db_, found->second, SqliteStatement::Of::kConnection);
  }
  const auto statement = Compile(sql);
  const bool kept = statement.ok() && prepared_.size() < kMostPrepared;
  if (kept) prepared_.emplace(sql, *statement);
  return std::make_unique<SqliteStatement>(
      db_, statement, kept ? SqliteStatement::Of::kConnection : SqliteStatement::Of::kItself);
}

absl::StatusOr<sqlite3_stmt*> SqliteConnection::Compile(std::string_view sql) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v3(db_, sql.data(), static_cast<int>(sql.size()),
                                      SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
  if (code != SQLITE_OK) return ErrorOf(db_, code);
  return statement;
}

}  // namespace slicefarm::coordinator
