#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

#include "services/coordinator/store/jobs/job_changes.h"
#include "services/coordinator/store/sql/postgres_connection.h"

namespace slicefarm::coordinator {

/// JobChanges by LISTEN and NOTIFY of PostgreSQL, over a connection of its own. While the server is
/// unreachable, it retries every second.
class PostgresJobChanges : public JobChanges {
 public:
  PostgresJobChanges(std::string conninfo, Listener listener);
  ~PostgresJobChanges() override;
  void Publish(const ProgressReport& report) override;

 private:
  void Run();
  void Listen(PostgresConnection& connection);
  absl::Status Notify(PostgresConnection& connection);
  /// Waits until bytes arrive at `socket`, the time has passed, or the object must stop.
  void Wait(int socket, int timeout_ms) const;

  const std::string conninfo_;
  const Listener listener_;
  int wake_ = -1;  ///< eventfd that ends a wait
  std::mutex mutex_;
  std::string notice_;  ///< notice to be sent; empty: none
  std::atomic<bool> stopping_ = false;
  std::thread thread_;
};

}  // namespace slicefarm::coordinator
