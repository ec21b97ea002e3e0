#pragma once

#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "services/cli/console/console.h"
#include "services/cli/farm/jobs_client.h"

namespace slicefarm::cli {

/// ProgressBar of one job. While the job waits, it shows the job's position in the queue, which it
/// requests every two seconds. Then it shows the number of finished layers.
class WatchBar {
 public:
  /// Creates the bar. `wanted`: false if nothing is to be shown. `client`: options for a second
  /// client that requests the position in the queue.
  WatchBar(bool wanted, JobsClientOptions client, std::string job_id);
  ~WatchBar() { Clear(); }

  /// Shows the state that an event of the job contains.
  void Show(const v1::Job& event);
  /// Removes the bar and ends the requests.
  void Clear();

 private:
  void AskForPlaces(const std::stop_token& stop);

  JobsClientOptions options_;
  const std::string job_id_;
  std::mutex mutex_;
  ProgressBar bar_;
  bool queued_ = false;
  std::condition_variable_any changed_;
  std::jthread thread_;  // last member, because it uses the members above
};

}  // namespace slicefarm::cli
