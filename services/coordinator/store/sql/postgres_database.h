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

  /// Opens a database and brings it to the schema of this build. Several programs may do so at the
  /// same time. Errors: STORE_FAILED (FailedPrecondition if the schema is newer than this build).
  static absl::StatusOr<std::unique_ptr<PostgresDatabase>> Open(const std::string& conninfo,
                                                                int max_connections = kConnections);

  /// Uses `pulse` from now on: if the server is silent, requests for a connection fail at once
  /// instead of waiting. REQUIRES: called before More.
  void Heed(std::shared_ptr<const PostgresPulse> pulse) { pulse_ = std::move(pulse); }

  /// Returns a second object for the same database with connections of its own, for users that must
  /// not wait for the connections of this object.
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
  /// Detects a silent server; if null, only the time limits of the calls detect one.
  std::shared_ptr<const PostgresPulse> pulse_;
  std::mutex mutex_;
  std::condition_variable given_back_;
  int free_;  ///< number of connections that may still be taken
  std::vector<std::unique_ptr<PostgresConnection>> idle_;
};

}  // namespace slicefarm::coordinator
