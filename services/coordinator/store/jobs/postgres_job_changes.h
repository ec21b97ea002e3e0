#pragma once

#include <atomic>
#include <string>
#include <thread>

#include "services/coordinator/store/jobs/job_changes.h"
#include "services/coordinator/store/sql/postgres_connection.h"

namespace slicefarm::coordinator {

/// Changes by LISTEN, over a connection of its own. While the server is away it tries again every
/// second.
class PostgresJobChanges : public JobChanges {
 public:
  PostgresJobChanges(std::string conninfo, Listener listener);
  ~PostgresJobChanges() override;

 private:
  void Run();
  void Listen(PostgresConnection& connection);
  /// Until something comes, the time has passed, or it is to stop.
  void Wait(int socket, int timeout_ms) const;

  const std::string conninfo_;
  const Listener listener_;
  int stop_ = -1;  ///< an eventfd
  std::atomic<bool> stopping_ = false;
  std::thread thread_;
};

}  // namespace slicefarm::coordinator
