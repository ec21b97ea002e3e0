#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "services/coordinator/store/sql.h"

struct pg_conn;
struct pg_result;

namespace slicefarm::coordinator {

/// One connection to a PostgreSQL database, with its prepared statements.
///
/// A statement's rows are all fetched at its first Next(). Errors: DISK_FULL; STORE_FAILED, as
/// Unavailable with a time to try again if the server is not there or gave up on the transaction.
class PostgresConnection : public SqlConnection {
 public:
  /// `conninfo` as libpq takes it: a URI, or keywords and values. Notices a server that has gone
  /// within 10 s, and lets no statement take longer than 30 s.
  static absl::StatusOr<std::unique_ptr<PostgresConnection>> Open(const std::string& conninfo);
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
  friend class PostgresStatement;
  explicit PostgresConnection(pg_conn* connection) : connection_(connection) {}
  absl::StatusOr<std::string> Find(std::string_view sql);

  pg_conn* connection_;
  std::map<std::string, std::string, std::less<>> prepared_;  ///< names by SQL
};

}  // namespace slicefarm::coordinator
