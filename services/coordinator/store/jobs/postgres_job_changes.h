#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

#include "services/coordinator/store/jobs/job_changes.h"
#include "services/coordinator/store/sql/postgres_connection.h"

namespace slicefarm::coordinator {

/// Changes by LISTEN, and reports by NOTIFY, over a connection of its own. While the server is away
/// it tries again every second.
class PostgresJobChanges : public JobChanges {
 public:
  PostgresJobChanges(std::string conninfo, Listener listener);
  ~PostgresJobChanges() override;
  void Tell(const ProgressReport& report) override;

 private:
  void Run();
  void Listen(PostgresConnection& connection);
  absl::Status Notify(PostgresConnection& connection);
  /// Until something comes, the time has passed, or it is to stop.
  void Wait(int socket, int timeout_ms) const;

  const std::string conninfo_;
  const Listener listener_;
  int wake_ = -1;  ///< an eventfd
  std::mutex mutex_;
  std::string notice_;  ///< to be told; empty: nothing is
  std::atomic<bool> stopping_ = false;
  std::thread thread_;
};

}  // namespace slicefarm::coordinator
