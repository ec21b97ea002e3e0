#pragma once

#include <prometheus/collectable.h>
#include <prometheus/metric_family.h>

#include <chrono>
#include <cstdint>
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

/// Metrics of the coordinator, in addition to its call metrics and to MeteredJobStore. They are
/// computed when Prometheus requests them:
///   slicefarm_jobs{state}                   jobs in the store; the count of ended jobs may be
///                                           up to a minute old;
///   slicefarm_queue_depth{priority}         waiting jobs in the store;
///   slicefarm_queue_age_seconds{priority}   age of the oldest waiting job;
///   slicefarm_store_up                      0: the store does not answer within the patience,
///                                           and its metrics are missing;
///   slicefarm_ranges_total{outcome}         layer ranges by outcome;
///   slicefarm_ranges_waiting                layer ranges that no worker has yet;
///   slicefarm_workers, slicefarm_worker_slots{state};
///   slicefarm_stage_up{stage}               0: no server of the stage can be reached;
///   slicefarm_disk_free_bytes, slicefarm_disk_size_bytes   disk of the state directory;
///   slicefarm_database_bytes                size of the shared database;
///   slicefarm_database_max_bytes            limit of this size, if there is one;
///   slicefarm_database_connections, slicefarm_database_max_connections   of the server;
///   slicefarm_preset_sets_total{from}       uses of sets of presets, from memory or store;
///   slicefarm_retention_overdue             1: a job exists a day after it should have gone.
/// Coordinators that share a store all report the values of the store: use the maximum over them,
/// not the sum.
class CoordinatorMetrics : public prometheus::Collectable {
 public:
  /// Uses of the sets of presets that jobs and calls name.
  struct PresetUses {
    int64_t from_memory = 0;
    int64_t from_store = 0;  ///< uses for which the set was read, which may take a second
  };

  /// Sources of the metrics.
  struct Sources {
    JobStore& jobs;
    const Dispatcher& dispatcher;
    const Fleet& fleet;
    std::string state_dir;  ///< state directory; empty if the state is not in a directory
    std::function<absl::StatusOr<DatabaseFill>()> database_fill =
        nullptr;                     ///< measures the shared database; null if there is none
    int64_t max_database_bytes = 0;  ///< largest size of the shared database; 0: no limit
    double keep_jobs_s = 0;          ///< storage time of ended jobs; 0: forever
    std::chrono::milliseconds patience{1000};           ///< longest wait for the store
    std::function<PresetUses()> preset_uses = nullptr;  ///< null if there are no presets
    /// function that returns, by stage, whether a server can be reached; null: no stages are known
    std::function<std::map<std::string, bool>()> stages_up = nullptr;
  };

  /// Facts that were read from the store.
  struct StoreFacts {
    absl::Status status;
    std::vector<OpenJobs> open;
    std::map<JobState, int64_t> jobs;
    std::optional<DatabaseFill> fill;
    std::optional<bool> retention_overdue;
  };

  /// Reads the values from `sources`, which must outlive this object.
  explicit CoordinatorMetrics(Sources sources)
      : sources_(std::move(sources)),
        counts_(sources_.jobs),
        store_([this] { return LookIntoStore(); }, sources_.patience) {}

  std::vector<prometheus::MetricFamily> Collect() const override;

 private:
  StoreFacts LookIntoStore();

  const Sources sources_;
  JobCounts counts_;
  /// Last facts that were read from the store; thread-safe in itself.
  mutable PatientLook<StoreFacts> store_;
};

/// Returns "bulk", "normal" or "interactive".
std::string PriorityName(Priority priority);

/// Returns the size and the free space of the disk with the directory. Returns nullopt if they
/// cannot be read or if `directory` is empty.
std::optional<std::filesystem::space_info> DiskOf(const std::string& directory);

/// Returns the seconds since `us` by the system's clock; at least 0.
double SecondsSince(int64_t us);

}  // namespace slicefarm::coordinator
