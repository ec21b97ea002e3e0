#include "services/coordinator/store/sqlite_connection.h"

#include <sqlite3.h>

#include "absl/strings/str_cat.h"
#include "common/model/error.h"

namespace slicefarm::coordinator {
namespace {

constexpr int kBusyTimeoutMs = 5000;

}  // namespace

absl::StatusOr<std::unique_ptr<SqliteConnection>> SqliteConnection::Open(const std::string& path) {
  sqlite3* db = nullptr;
  const int code = sqlite3_open_v2(
      path.c_str(), &db, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX, nullptr);
  std::unique_ptr<SqliteConnection> connection(new SqliteConnection(db));
  if (code != SQLITE_OK) return connection->Error(code);
  sqlite3_extended_result_codes(db, 1);
  sqlite3_busy_timeout(db, kBusyTimeoutMs);
  const absl::Status ready = connection->Execute(
      "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON;");
  if (!ready.ok()) return ready;
  return connection;
}

SqliteConnection::~SqliteConnection() {
  for (const auto& [sql, statement] : prepared_) sqlite3_finalize(statement);
  sqlite3_close(db_);
}

absl::Status SqliteConnection::Execute(const std::string& sql) {
  return Error(sqlite3_exec(db_, sql.c_str(), nullptr, nullptr, nullptr));
}

absl::Status SqliteConnection::Error(int code) const {
  if (code == SQLITE_OK) return absl::OkStatus();
  const std::string message = absl::StrCat("SQLite: ", sqlite3_errmsg(db_));
  switch (code & 0xff) {
    case SQLITE_FULL:
      return MakeError(absl::StatusCode::kResourceExhausted, Reason::kDiskFull, message);
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return MakeError(absl::StatusCode::kUnavailable, Reason::kStoreFailed, message);
    default:
      return MakeError(absl::StatusCode::kInternal, Reason::kStoreFailed, message);
  }
}

absl::StatusOr<sqlite3_stmt*> SqliteConnection::Prepare(std::string_view sql) {
  if (const auto found = prepared_.find(sql); found != prepared_.end()) return found->second;
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v3(db_, sql.data(), static_cast<int>(sql.size()),
                                      SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
  if (code != SQLITE_OK) return Error(code);
  prepared_.emplace(sql, statement);
  return statement;
}

SqliteQuery::SqliteQuery(SqliteConnection& connection, std::string_view sql)
    : connection_(connection) {
  auto statement = connection.Prepare(sql);
  if (statement.ok()) {
    statement_ = *statement;
  } else {
    status_ = statement.status();
  }
}

SqliteQuery::~SqliteQuery() {
  if (statement_ == nullptr) return;
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
}

void SqliteQuery::Check(int code) {
  if (code != SQLITE_OK && status_.ok()) status_ = connection_.Error(code);
}

void SqliteQuery::BindNext(int64_t value) {
  if (status_.ok()) Check(sqlite3_bind_int64(statement_, ++bound_, value));
}

void SqliteQuery::BindNext(std::string_view value) {
  if (!status_.ok()) return;
  Check(sqlite3_bind_text64(statement_, ++bound_, value.data(), value.size(), SQLITE_TRANSIENT,
                            SQLITE_UTF8));
}

void SqliteQuery::BindNext(Blob value) {
  if (!status_.ok()) return;
  Check(sqlite3_bind_blob64(statement_, ++bound_, value.bytes.data(), value.bytes.size(),
                            SQLITE_TRANSIENT));
}

bool SqliteQuery::Next() {
  if (!status_.ok()) return false;
  const int code = sqlite3_step(statement_);
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) Check(code);
  return false;
}

absl::Status SqliteQuery::Run() {
  while (Next()) {
  }
  return status_;
}

int64_t SqliteQuery::Int(int column) const { return sqlite3_column_int64(statement_, column); }

std::string SqliteQuery::Text(int column) const {
  const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement_, column));
  return std::string(bytes == nullptr ? "" : bytes, sqlite3_column_bytes(statement_, column));
}

SqliteTransaction::SqliteTransaction(SqliteConnection& connection) : connection_(connection) {
  status_ = SqliteQuery(connection_, "BEGIN IMMEDIATE").Run();
  open_ = status_.ok();
}

SqliteTransaction::~SqliteTransaction() {
  if (open_) SqliteQuery(connection_, "ROLLBACK").Run().IgnoreError();
}

absl::Status SqliteTransaction::Commit() {
  absl::Status committed = SqliteQuery(connection_, "COMMIT").Run();
  open_ = !committed.ok();
  return committed;
}

}  // namespace slicefarm::coordinator
