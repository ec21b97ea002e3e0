#pragma once

#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "services/cli/console/console.h"
#include "services/cli/farm/jobs_client.h"

namespace slicefarm::cli {

/// ProgressBar of one job. While the job waits, it shows the place in the queue, requested every
/// two seconds. Then it shows the layers.
class WatchBar {
 public:
  /// `client`: connection for a client of its own.
  WatchBar(bool wanted, JobsClientOptions client, std::string job_id);
  ~WatchBar() { Clear(); }

  /// Shows the state in an event of the job.
  void Show(const v1::Job& event);
  /// Ends the bar.
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
