#pragma once

#include <chrono>
#include <string>

#include "common/rpc/server/serve.h"
#include "services/coordinator/server/execution/job_runner.h"
#include "services/coordinator/server/execution/maintenance.h"
#include "services/coordinator/server/execution/split_stages.h"
#include "services/coordinator/server/main/stores.h"

namespace slicefarm::coordinator {

/// What slicefarm-coordinator can be told. Addresses are host:port, with commas between several;
/// each name may stand for any number of replicas.
struct CoordinatorFlags {
  rpc::ServeFlags serve;
  StoreOptions stores;
  std::string spool_dir;  ///< empty: CoordinatorOptions::spool_dir says
  std::string slicing;
  std::string planning;
  std::string motion;
  std::string exposure;  ///< empty: no jobs of lasers
  std::string workers;   ///< fused; or the three below
  std::string beading;
  std::string infill;
  std::string ordering;
  int split_slots = 8;  ///< ranges in flight over the split stages
  JobRunnerOptions runner;
  std::string rates_file;
  std::string webhooks_file;
  std::string tenants_file;  ///< empty: one tenant, who is anybody
  bool share_cache = false;
  int64_t min_free_mib = 1024;
  int64_t max_database_gib = 0;
  int64_t memory_mib = DefaultMemoryBudget() >> 20;
  double lease_s = 10;
  double keep_jobs_days = 0;
  double keep_blobs_hours = 24;

  bool split() const { return !beading.empty(); }
  SplitStages::Names split_names() const;
  JobRunnerOptions runner_options() const;
  Maintenance::Options maintenance() const;
  /// How long jobs that run may go on after SIGTERM: what they leave of --drain suffices to hand
  /// them back, and to end calls.
  std::chrono::milliseconds drain_of_jobs() const;
};

/// Also checks that either workers or all split stages are given.
void AddCoordinatorFlags(CLI::App& app, CoordinatorFlags* flags);

}  // namespace slicefarm::coordinator
