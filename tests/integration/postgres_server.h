#pragma once

#include <string>

namespace slicefarm {

/// A PostgreSQL server of one test process, by `deploy/postgres/server.sh`, as long as it is in
/// scope.
class PostgresServer {
 public:
  enum class Disk { kTrusted, kFsync };

  /// Dies if it does not start. Without fsync it is faster, and survives kills all the same.
  explicit PostgresServer(Disk disk = Disk::kTrusted);
  ~PostgresServer();
  PostgresServer(const PostgresServer&) = delete;
  PostgresServer& operator=(const PostgresServer&) = delete;

  /// The connection string of a new, empty database.
  std::string NewDatabase();

  /// SIGKILL to all of its processes.
  void Kill();
  /// After Kill.
  void Start();

  /// All of its processes stand still: nobody answers, and no connection ends.
  void Pause();
  /// After Pause.
  void Resume();

 private:
  std::string Run(const std::string& command, const std::string& settings = "");

  std::string directory_;
  std::string settings_;
  int databases_ = 0;
};

}  // namespace slicefarm
