#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "common/base/stopwatch.h"
#include "common/rpc/observe/json_log.h"
#include "services/coordinator/remote/stage_pool.h"
#include "services/coordinator/server/observe/coordinator_metrics.h"
#include "services/coordinator/server/observe/patient_look.h"
#include "services/coordinator/server/observe/status_page.h"

namespace slicefarm::coordinator {

/// Collects the status of a coordinator for its page /statusz. Thread-safe.
class StatusBoard {
 public:
  /// Sources of the status.
  struct Sources {
    std::string name;
    std::string store;  ///< kind and address of the store, without secrets
    std::string state_dir;
    JobStore& jobs;
    const Fleet& fleet;
    std::map<std::string, const StagePool*> stages;
    rpc::JsonLog log;
    /// Adds the progress of a running job to its record.
    std::function<void(JobRecord&)> add_progress = [](JobRecord&) {};
    std::chrono::milliseconds patience{1000};  ///< longest wait for the store
  };

  /// Facts that were read from the store.
  struct StoreFacts {
    absl::Status status;
    std::map<JobState, int64_t> jobs;
    std::vector<OpenJobs> open;
    std::vector<JobRecord> running;
  };

  /// Reads the status from `sources`, which must outlive this object.
  explicit StatusBoard(Sources sources)
      : sources_(std::move(sources)),
        counts_(sources_.jobs),
        store_([this] { return LookIntoStore(); }, sources_.patience) {}

  /// Returns the current status.
  CoordinatorStatus Look() const;
  /// Returns the status as a page of HTML.
  std::string Page() const { return StatusPage(Look()); }

 private:
  StoreFacts LookIntoStore();

  const Sources sources_;
  JobCounts counts_;
  mutable PatientLook<StoreFacts> store_;  ///< thread-safe in itself
  const Stopwatch uptime_;
};

}  // namespace slicefarm::coordinator
