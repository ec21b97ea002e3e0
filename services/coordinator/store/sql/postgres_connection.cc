#include "services/coordinator/store/sql/postgres_connection.h"

#include <libpq-fe.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/strip.h"
#include "common/base/error.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::coordinator {
namespace {

constexpr SqlDialect kPostgresDialect = {
    .begin = "BEGIN",
    .for_update = " FOR UPDATE",
    .skip_locked = " FOR UPDATE SKIP LOCKED",
    .lock_tenant = "SELECT 1 FROM pg_advisory_xact_lock(hashtextextended(?, 5117318))",
    .lock_work = "SELECT 1 FROM pg_advisory_xact_lock(hashtextextended(?, 5117319))",
    .notify = "SELECT pg_notify('slicefarm_jobs', ?)",
    .spec = "spec",
    .texts = "json_array_elements_text(?::JSON)",
    .writes_in_with = true,
    .names_indexes = false,
};

/// Later settings of a connection string override earlier ones, so these are only defaults for
/// `conninfo`.
constexpr std::array<const char*, 8> kKeywords = {
    "connect_timeout",
    "keepalives_idle",
    "keepalives_interval",
    "keepalives_count",
    "tcp_user_timeout",
    "application_name",
    "dbname",
    nullptr,
};

/// Longest pause of a transaction between two statements. A coordinator that is stopped, or has
/// lost its machine, would otherwise keep its locks and prevent other coordinators from claiming
/// jobs.
constexpr std::chrono::milliseconds kIdleLimit = std::chrono::seconds(5);
constexpr std::string_view kIdleInTransaction = "25P03";

using Clock = std::chrono::steady_clock;

std::unique_ptr<pg_result, void (*)(pg_result*)> Own(pg_result* result) {
  return {result, PQclear};
}

/// Removes the line end after a message of libpq.
std::string Message(const std::string& text) {
  return absl::StrCat("PostgreSQL: ", absl::StripTrailingAsciiWhitespace(text));
}

absl::Status Away(const std::string& text) { return StoreAway(Message(text)); }

/// Converts an error by its SQLSTATE class:
/// https://www.postgresql.org/docs/15/errcodes-appendix.html
absl::Status ErrorOf(pg_conn* connection, const pg_result* result) {
  const ExecStatusType status = PQresultStatus(result);
  if (status == PGRES_COMMAND_OK || status == PGRES_TUPLES_OK) return absl::OkStatus();
  const char* code = PQresultErrorField(result, PG_DIAG_SQLSTATE);
  const std::string_view state = code == nullptr ? "" : code;
  if (state == "53100") {
    return MakeError(absl::StatusCode::kResourceExhausted, Reason::kDiskFull,
                     Message(PQresultErrorMessage(result)));
  }
  // Temporary errors: a lost connection; a transaction that the server aborted (deadlock); too many
  // connections; a lock of another transaction; a server that stops or starts.
  const bool away = PQstatus(connection) != CONNECTION_OK || state == kIdleInTransaction ||
                    state.starts_with("08") || state.starts_with("40") || state.starts_with("53") ||
                    state.starts_with("57") || state == "55P03";
  const char* text = PQresultErrorMessage(result);
  if (*text == '\0') text = PQerrorMessage(connection);
  if (away) return Away(text);
  return MakeError(absl::StatusCode::kInternal, Reason::kStoreFailed, Message(text));
}

/// Returns true if the socket becomes readable before `until`. With `writes`, it may also become
/// writable.
bool IsReady(int socket, bool writes, Clock::time_point until) {
  pollfd ready = {socket, static_cast<int16_t>(writes ? POLLIN | POLLOUT : POLLIN), 0};
  while (true) {
    int left_ms = -1;
    if (until != Clock::time_point::max()) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
      left_ms = static_cast<int>(std::max<int64_t>(0, left.count()));
    }
    const int count = poll(&ready, 1, left_ms);
    if (count >= 0 || errno != EINTR) return count != 0;
  }
}

/// Sends the pending bytes and reads until there is a result, the end of the results, or a broken
/// connection. Returns false if it took too long.
bool Exchange(pg_conn* connection, Clock::time_point until) {
  int unsent = PQflush(connection);
  while (unsent > 0 || PQisBusy(connection) == 1) {
    if (!IsReady(PQsocket(connection), unsent > 0, until)) return false;
    if (PQconsumeInput(connection) == 0) return true;
    if (unsent > 0) unsent = PQflush(connection);
  }
  return true;
}

/// Converts the parameters `?` to `$1`, `$2`, ... No string in the store's statements contains a
/// question mark.
std::string Numbered(std::string_view sql) {
  std::string numbered;
  int next = 1;
  for (const char c : sql) {
    if (c == '?') {
      absl::StrAppend(&numbered, "$", next++);
    } else {
      numbered += c;
    }
  }
  return numbered;
}

int64_t FromNetwork(const char* bytes, int length) {
  uint64_t value = 0;
  for (int i = 0; i < length; ++i) value = value << 8 | static_cast<uint8_t>(bytes[i]);
  const int unused = 64 - 8 * length;
  return length == 0 ? 0 : static_cast<int64_t>(value << unused) >> unused;
}

}  // namespace

class PostgresStatement : public SqlStatement {
 public:
  /// Creates a statement. `name`: name of the prepared statement; if empty, `sql` is not prepared.
  PostgresStatement(PostgresConnection& connection, std::string_view sql,
                    absl::StatusOr<std::string> name)
      : connection_(connection), status_(name.status()), result_(Own(nullptr)) {
    if (name.ok()) name_ = *std::move(name);
    if (name_.empty()) sql_ = Numbered(sql);
  }

  void Bind(int64_t value) override { Add(absl::StrCat(value), /*binary=*/false); }
  void Bind(std::string_view value) override {
    // libpq would use only the text before the NUL.
    if (value.find('\0') != std::string_view::npos) {
      status_.Update(MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                               "a text has a NUL character"));
    }
    Add(std::string(value), /*binary=*/false);
  }
  void Bind(Blob value) override { Add(std::string(value.bytes), /*binary=*/true); }

  bool Next() override {
    if (!status_.ok()) return false;
    if (row_ < 0) Run();
    return status_.ok() && ++row_ < PQntuples(result_.get());
  }
  const absl::Status& status() const override { return status_; }

  int64_t Int(int column) const override {
    return FromNetwork(PQgetvalue(result_.get(), row_, column),
                       PQgetlength(result_.get(), row_, column));
  }
  std::string Text(int column) const override {
    return std::string(PQgetvalue(result_.get(), row_, column),
                       PQgetlength(result_.get(), row_, column));
  }

 private:
  void Add(std::string value, bool binary) {
    values_.push_back(std::move(value));
    formats_.push_back(binary ? 1 : 0);
  }

  void Run() {
    std::vector<const char*> values;
    std::vector<int> lengths;
    for (const std::string& value : values_) {
      values.push_back(value.c_str());
      lengths.push_back(static_cast<int>(value.size()));
    }
    const int count = static_cast<int>(values.size());
    auto answer = connection_.Answer(
        name_.empty()
            ? PQsendQueryParams(connection_.raw(), sql_.c_str(), count, nullptr, values.data(),
                                lengths.data(), formats_.data(), /*resultFormat=*/1)
            : PQsendQueryPrepared(connection_.raw(), name_.c_str(), count, values.data(),
                                  lengths.data(), formats_.data(), /*resultFormat=*/1));
    status_ = answer.status();
    if (answer.ok()) result_ = *std::move(answer);
  }

  PostgresConnection& connection_;
  std::string name_;
  std::string sql_;
  absl::Status status_;
  std::vector<std::string> values_;
  std::vector<int> formats_;
  PostgresConnection::Result result_;
  int row_ = -1;
};

absl::StatusOr<std::unique_ptr<PostgresConnection>> PostgresConnection::Open(
    const std::string& conninfo, Limit limit) {
  constexpr std::array<const char*, kKeywords.size()> kValues = {
      "5", "5", "2", "3", "10000", "slicefarm", nullptr, nullptr};
  std::array<const char*, kKeywords.size()> values = kValues;
  values[kKeywords.size() - 2] = conninfo.c_str();
  std::unique_ptr<PostgresConnection> connection(new PostgresConnection(
      PQconnectdbParams(kKeywords.data(), values.data(), /*expand_dbname=*/1), limit));
  if (!connection->alive()) return Away(PQerrorMessage(connection->connection_));
  PQsetNoticeProcessor(
      connection->connection_, [](void*, const char*) {}, nullptr);
  PQsetnonblocking(connection->connection_, 1);
  absl::Status ready = connection->Execute(
      absl::StrCat("SET statement_timeout = ", limit.count(),
                   "; SET idle_in_transaction_session_timeout = ", kIdleLimit.count()));
  if (!ready.ok()) return ready;
  return connection;
}

PostgresConnection::~PostgresConnection() { PQfinish(connection_); }

const SqlDialect& PostgresConnection::dialect() const { return kPostgresDialect; }

bool PostgresConnection::alive() const {
  return !given_up_ && PQstatus(connection_) == CONNECTION_OK;
}

absl::Status PostgresConnection::Execute(const std::string& sql) {
  return Answer(PQsendQuery(connection_, sql.c_str())).status();
}

std::unique_ptr<SqlStatement> PostgresConnection::Prepare(std::string_view sql) {
  return std::make_unique<PostgresStatement>(*this, sql, Find(sql));
}

/// Returns the name of the prepared statement, and prepares it if needed. Returns an empty name if
/// the connection already has the largest number of prepared statements.
absl::StatusOr<std::string> PostgresConnection::Find(std::string_view sql) {
  if (const auto found = prepared_.find(sql); found != prepared_.end()) return found->second;
  if (prepared_.size() >= kMostPrepared) return std::string();
  const std::string name = absl::StrCat("s", prepared_.size());
  const auto answer =
      Answer(PQsendPrepare(connection_, name.c_str(), Numbered(sql).c_str(), 0, nullptr));
  if (!answer.ok()) return answer.status();
  prepared_.emplace(sql, name);
  return name;
}

/// Returns the last result of the commands that were `sent`, as the blocking functions of libpq do,
/// but with a time limit.
absl::StatusOr<PostgresConnection::Result> PostgresConnection::Answer(int sent) {
  const auto until =
      limit_ == kNoLimit ? Clock::time_point::max() : Clock::now() + limit_ + limit_ / 10;
  if (given_up_) return Away("the connection was given up");
  Result last = Own(nullptr);
  while (sent == 1) {
    if (!Exchange(connection_, until)) {
      given_up_ = true;  // a late answer would be mistaken for the answer to the next statement
      shutdown(PQsocket(connection_), SHUT_RDWR);
      return Away(absl::StrCat("no answer within ", limit_.count(), " ms"));
    }
    Result next = Own(PQgetResult(connection_));
    if (!next) break;
    last = std::move(next);
  }
  if (absl::Status error = ErrorOf(connection_, last.get()); !error.ok()) return error;
  return last;
}

}  // namespace slicefarm::coordinator
