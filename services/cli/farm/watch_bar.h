#pragma once

#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "services/cli/console/console.h"
#include "services/cli/farm/jobs_client.h"

namespace slicefarm::cli {

/// A ProgressBar of one job: its place in the queue, asked for every two seconds while it waits,
/// and then its layers.
class WatchBar {
 public:
  /// `client`: how to reach the farm, for a client of its own.
  WatchBar(bool wanted, JobsClientOptions client, std::string job_id);
  ~WatchBar() { Clear(); }

  /// Shows what an event of the job tells.
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
  std::jthread thread_;  // the last member
};

}  // namespace slicefarm::cli
