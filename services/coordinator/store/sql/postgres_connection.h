#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "services/coordinator/store/sql/sql.h"

struct pg_conn;
struct pg_result;

namespace slicefarm::coordinator {

/// Connection to a PostgreSQL database, with its prepared statements.
///
/// The first Next() of a statement fetches all its rows. Errors: DISK_FULL; STORE_FAILED. If the
/// server is unreachable or has aborted the transaction, STORE_FAILED has the code Unavailable and
/// a time to retry.
class PostgresConnection : public SqlConnection {
 public:
  /// Time limit of one statement.
  using Limit = std::chrono::milliseconds;
  static constexpr Limit kLimit = std::chrono::seconds(30);
  static constexpr Limit kNoLimit = Limit::zero();

  /// Opens a connection. `conninfo`: connection string of libpq (a URI, or keywords and values). A
  /// lost server is detected within 10 s. The server ends statements that take longer than `limit`.
  /// If it has not done so after 1.1 times `limit`, the connection ends.
  static absl::StatusOr<std::unique_ptr<PostgresConnection>> Open(const std::string& conninfo,
                                                                  Limit limit = kLimit);
  ~PostgresConnection() override;
  PostgresConnection(const PostgresConnection&) = delete;
  PostgresConnection& operator=(const PostgresConnection&) = delete;

  const SqlDialect& dialect() const override;
  absl::Status Execute(const std::string& sql) override;
  std::unique_ptr<SqlStatement> Prepare(std::string_view sql) override;

  /// Returns false after the connection broke. A broken connection is not opened again.
  bool alive() const;
  /// Returns libpq's connection, for functions that SqlConnection lacks: LISTEN.
  pg_conn* raw() { return connection_; }

 private:
  using Result = std::unique_ptr<pg_result, void (*)(pg_result*)>;

  friend class PostgresStatement;
  PostgresConnection(pg_conn* connection, Limit limit) : connection_(connection), limit_(limit) {}
  absl::StatusOr<std::string> Find(std::string_view sql);
  absl::StatusOr<Result> Answer(int sent);

  pg_conn* connection_;
  const Limit limit_;
  /// True if the server did not answer in time, so that the connection was ended.
  bool given_up_ = false;
  /// Names of prepared statements, by SQL.
  std::map<std::string, std::string, std::less<>> prepared_;
};

}  // namespace slicefarm::coordinator
