#pragma once

#include <string>

namespace slicefarm {

/// PostgreSQL server of one test process, by `deploy/postgres/server.sh`, until its scope ends.
class PostgresServer {
 public:
  enum class Disk { kTrusted, kFsync };

  /// Aborts if the server does not start. Without fsync it is faster, and it still survives kills.
  explicit PostgresServer(Disk disk = Disk::kTrusted);
  ~PostgresServer();
  PostgresServer(const PostgresServer&) = delete;
  PostgresServer& operator=(const PostgresServer&) = delete;

  /// Returns the connection string of a new, empty database.
  std::string NewDatabase();

  /// Sends SIGKILL to all processes of the server.
  void Kill();
  /// Starts the server again after Kill.
  void Start();

  /// Stops all processes of the server: it does not answer, and no connection ends.
  void Pause();
  /// Continues after Pause.
  void Resume();

 private:
  std::string Run(const std::string& command, const std::string& settings = "");

  std::string directory_;
  std::string settings_;
  int databases_ = 0;
};

}  // namespace slicefarm
