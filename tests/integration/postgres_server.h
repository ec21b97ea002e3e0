#pragma once

#include <string>

namespace slicefarm {

/// PostgreSQL server of one test program, started by `deploy/postgres/server.sh`. The destructor
/// stops the server.
class PostgresServer {
 public:
  enum class Disk { kTrusted, kFsync };

  /// Starts the server. Aborts if it does not start. `disk`: kTrusted runs without fsync, which is
  /// faster; the data still survives kills of the server's processes.
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

  /// Stops all processes of the server with SIGSTOP: the server does not answer, and no connection
  /// ends.
  void Pause();
  /// Lets the processes continue after Pause.
  void Resume();

 private:
  std::string Run(const std::string& command, const std::string& settings = "");

  std::string directory_;
  std::string settings_;
  int databases_ = 0;
};

}  // namespace slicefarm
