#pragma once

#include <functional>
#include <map>
#include <string>

#include "common/base/stopwatch.h"
#include "common/rpc/observe/json_log.h"
#include "services/coordinator/remote/stage_pool.h"
#include "services/coordinator/server/observe/coordinator_metrics.h"
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
  };

  /// The sources must outlive it.
  explicit StatusBoard(Sources sources) : sources_(std::move(sources)), counts_(sources_.jobs) {}

  CoordinatorStatus Look() const;
  std::string Page() const { return StatusPage(Look()); }

 private:
  const Sources sources_;
  mutable JobCounts counts_;  ///< locked within
  const Stopwatch uptime_;
};

}  // namespace slicefarm::coordinator
