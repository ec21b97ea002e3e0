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

/// Looks around in a coordinator for its page /statusz. Thread-safe.
class StatusBoard {
 public:
  struct Sources {
    std::string name;
    std::string store;  ///< which one, without secrets
    std::string state_dir;
    JobStore& jobs;
    const Fleet& fleet;
    std::map<std::string, const StagePool*> stages;
    rpc::JsonLog log;
    /// Puts into a running job's record how far it has come.
    std::function<void(JobRecord&)> add_progress = [](JobRecord&) {};
    std::chrono::milliseconds patience{1000};  ///< with the store
  };

  /// What the store has said.
  struct StoreFacts {
    absl::Status status;
    std::map<JobState, int64_t> jobs;
    std::vector<OpenJobs> open;
    std::vector<JobRecord> running;
  };

  /// The sources must outlive it.
  explicit StatusBoard(Sources sources)
      : sources_(std::move(sources)),
        counts_(sources_.jobs),
        store_([this] { return LookIntoStore(); }, sources_.patience) {}

  CoordinatorStatus Look() const;
  std::string Page() const { return StatusPage(Look()); }

 private:
  StoreFacts LookIntoStore();

  const Sources sources_;
  JobCounts counts_;
  mutable PatientLook<StoreFacts> store_;  ///< locked within
  const Stopwatch uptime_;
};

}  // namespace slicefarm::coordinator
