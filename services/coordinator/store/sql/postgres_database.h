#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "services/coordinator/store/sql/postgres_connection.h"
#include "services/coordinator/store/sql/postgres_pulse.h"

namespace slicefarm::coordinator {

/// PostgreSQL database with a limited number of connections. Connections are opened when needed,
/// and again after the server was unreachable.
class PostgresDatabase : public SqlDatabase {
 public:
  static constexpr int kConnections = 8;

  /// Opens a database and brings it to the current schema. Several processes may do so at the same
  /// time. Errors: STORE_FAILED (FailedPrecondition if the schema is newer than this build).
  static absl::StatusOr<std::unique_ptr<PostgresDatabase>> Open(const std::string& conninfo,
                                                                int max_connections = kConnections);

  /// Uses `pulse` from now on: while the server is silent, requests for a connection fail at once
  /// instead of waiting. REQUIRES: called before More.
  void Heed(std::shared_ptr<const PostgresPulse> pulse) { pulse_ = std::move(pulse); }

  /// Returns a database with other connections, for users that must not wait for these connections.
  std::unique_ptr<PostgresDatabase> More(int max_connections = kConnections) const {
    std::unique_ptr<PostgresDatabase> more(new PostgresDatabase(conninfo_, max_connections));
    more->pulse_ = pulse_;
    return more;
  }

  absl::StatusOr<SqlSession> Read() override { return Take(); }
  absl::StatusOr<SqlSession> Write() override { return Take(); }

 private:
  PostgresDatabase(std::string conninfo, int max_connections)
      : conninfo_(std::move(conninfo)), free_(max_connections) {}

  absl::Status CheckPulse() const;
  absl::StatusOr<SqlSession> Take();
  void GiveBack(std::unique_ptr<PostgresConnection> connection);

  const std::string conninfo_;
  /// Null: a silent server is noticed only by waiting.
  std::shared_ptr<const PostgresPulse> pulse_;
  std::mutex mutex_;
  std::condition_variable given_back_;
  int free_;  ///< number of connections that may still be taken
  std::vector<std::unique_ptr<PostgresConnection>> idle_;
};

}  // namespace slicefarm::coordinator
