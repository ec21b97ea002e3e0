#pragma once

#include <prometheus/collectable.h>
#include <prometheus/metric_family.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "services/coordinator/algo/dispatch/dispatcher.h"
#include "services/coordinator/algo/dispatch/fleet.h"
#include "services/coordinator/server/observe/job_counts.h"
#include "services/coordinator/server/observe/patient_look.h"
#include "services/coordinator/store/jobs/job_store.h"
#include "services/coordinator/store/sql/database_fill.h"

namespace slicefarm::coordinator {

/// What the coordinator shows beside its calls and what MeteredJobStore counts; looked up when
/// Prometheus asks:
///   slicefarm_jobs{state}                   in the store, as is the next; ended ones as they were
///                                           at most a minute ago
///   slicefarm_queue_depth{priority}, slicefarm_queue_age_seconds{priority}
///   slicefarm_store_up                      0: it does not answer within the patience, and what is
///                                           in it is missing
///   slicefarm_ranges_total{outcome}
///   slicefarm_workers, slicefarm_worker_slots{state}
///   slicefarm_disk_free_bytes, slicefarm_disk_size_bytes   of a state directory
///   slicefarm_database_bytes, slicefarm_database_max_bytes   of a database that is shared; max: if
///   any slicefarm_database_connections, slicefarm_database_max_connections   of its server
///   slicefarm_retention_overdue             1: a job is there a day after it should have gone
/// Coordinators that share a store all show what is in it: take the maximum over them, not the sum.
class CoordinatorMetrics : public prometheus::Collectable {
 public:
  struct Sources {
    JobStore& jobs;
    const Dispatcher& dispatcher;
    const Fleet& fleet;
    std::string state_dir;  ///< empty: there is none
    std::function<absl::StatusOr<DatabaseFill>()> database_fill =
        nullptr;                               ///< null: it is not shared
    int64_t max_database_bytes = 0;            ///< 0: any number
    double keep_jobs_s = 0;                    ///< 0: for ever
    std::chrono::milliseconds patience{1000};  ///< with the store
  };

  /// What the store has said.
  struct StoreFacts {
    absl::Status status;
    std::vector<OpenJobs> open;
    std::map<JobState, int64_t> jobs;
    std::optional<DatabaseFill> fill;
    std::optional<bool> retention_overdue;
  };

  /// The sources must outlive it.
  explicit CoordinatorMetrics(Sources sources)
      : sources_(std::move(sources)),
        counts_(sources_.jobs),
        store_([this] { return LookIntoStore(); }, sources_.patience) {}

  std::vector<prometheus::MetricFamily> Collect() const override;

 private:
  StoreFacts LookIntoStore();

  const Sources sources_;
  JobCounts counts_;
  mutable PatientLook<StoreFacts> store_;  ///< locked within
};

/// "bulk", "normal", "interactive".
std::string PriorityName(Priority priority);

/// Of the disk that a directory lies on; none if it cannot be looked at, or `directory` is empty.
std::optional<std::filesystem::space_info> DiskOf(const std::string& directory);

/// Seconds since `us`, on the system's clock; not below 0.
double SecondsSince(int64_t us);

}  // namespace slicefarm::coordinator
