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

/// One connection to a PostgreSQL database, with its prepared statements.
///
/// A statement's rows are all fetched at its first Next(). Errors: DISK_FULL; STORE_FAILED, as
/// Unavailable with a time to try again if the server is not there or gave up on the transaction.
class PostgresConnection : public SqlConnection {
 public:
  /// Of one statement.
  using Limit = std::chrono::milliseconds;
  static constexpr Limit kLimit = std::chrono::seconds(30);
  static constexpr Limit kNoLimit = Limit::zero();

  /// `conninfo` as libpq takes it: a URI, or keywords and values. Notices a server that has gone
  /// within 10 s. Statements that take longer than `limit` end; so does the connection if the
  /// server does not say so itself, a tenth of that later, because it stands still.
  static absl::StatusOr<std::unique_ptr<PostgresConnection>> Open(const std::string& conninfo,
                                                                  Limit limit = kLimit);
  ~PostgresConnection() override;
  PostgresConnection(const PostgresConnection&) = delete;
  PostgresConnection& operator=(const PostgresConnection&) = delete;

  const SqlDialect& dialect() const override;
  absl::Status Execute(const std::string& sql) override;
  std::unique_ptr<SqlStatement> Prepare(std::string_view sql) override;

  /// False after the connection broke; it stays so.
  bool alive() const;
  /// For what libpq's interface for SQL lacks: LISTEN.
  pg_conn* raw() { return connection_; }

 private:
  using Result = std::unique_ptr<pg_result, void (*)(pg_result*)>;

  friend class PostgresStatement;
  PostgresConnection(pg_conn* connection, Limit limit) : connection_(connection), limit_(limit) {}
  absl::StatusOr<std::string> Find(std::string_view sql);
  absl::StatusOr<Result> Answer(int sent);

  pg_conn* connection_;
  const Limit limit_;
  bool given_up_ = false;                                     ///< it did not answer in time
  std::map<std::string, std::string, std::less<>> prepared_;  ///< names by SQL
};

}  // namespace slicefarm::coordinator
