#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "services/coordinator/store/sql/postgres_connection.h"
#include "services/coordinator/store/sql/postgres_pulse.h"

namespace slicefarm::coordinator {

/// A PostgreSQL database with a bounded number of connections. They are made when they are needed,
/// and anew after the server was away.
class PostgresDatabase : public SqlDatabase {
 public:
  static constexpr int kConnections = 8;

  /// Brings the database to the present schema; several may do so at a time. Errors: STORE_FAILED
  /// (FailedPrecondition if its schema is newer than this build).
  static absl::StatusOr<std::unique_ptr<PostgresDatabase>> Open(const std::string& conninfo,
                                                                int max_connections = kConnections);

  /// From now on nobody waits for a connection while the server is silent: that is an error at
  /// once. Before More.
  void Heed(std::shared_ptr<const PostgresPulse> pulse) { pulse_ = std::move(pulse); }

  /// Other connections to the same database, for those whom these are not to keep waiting.
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
  std::shared_ptr<const PostgresPulse> pulse_;  ///< null: its silence is noticed by waiting
  std::mutex mutex_;
  std::condition_variable given_back_;
  int free_;  ///< how many more may be taken
  std::vector<std::unique_ptr<PostgresConnection>> idle_;
};

}  // namespace slicefarm::coordinator
