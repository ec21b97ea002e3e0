#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "common/rpc/server/serve.h"
#include "services/coordinator/server/execution/job_runner.h"
#include "services/coordinator/server/execution/maintenance.h"
#include "services/coordinator/server/execution/stage_pools.h"
#include "services/coordinator/server/main/s3_flags.h"
#include "services/coordinator/server/main/stores.h"

namespace slicefarm::coordinator {

/// What slicefarm-coordinator can be told. Addresses are host:port, with commas between several;
/// each name may stand for any number of replicas.
struct CoordinatorFlags {
  rpc::ServeFlags serve;
  StoreOptions stores;  ///< but for the bucket, which `s3` says
  S3Flags s3;
  std::string spool_dir;  ///< empty: CoordinatorOptions::spool_dir says
  std::map<Stage, std::string>
      stages;           ///< those that are services; which there must be, Check says
  std::string workers;  ///< fused; or the stages of layers
  int split_slots = 8;  ///< ranges in flight over the split stages
  JobRunnerOptions runner;
  std::string rates_file;
  std::string default_profile;
  std::string webhooks_file;
  std::string tenants_file;  ///< empty: one tenant, who is anybody
  bool share_cache = false;
  int64_t min_free_mib = 1024;
  int64_t max_database_gib = 0;
  int64_t memory_mib = DefaultMemoryBudget() >> 20;
  double lease_s = 10;
  double keep_jobs_days = 0;
  double keep_blobs_hours = 24;
  double sweep_after_hours = 24;

  /// Whether the stages of layers are services, rather than in workers.
  bool split() const { return Has(Stage::kBeading); }
  bool Has(Stage stage) const { return stages.contains(stage) && !stages.at(stage).empty(); }
  std::map<Stage, std::vector<std::string>> stage_names() const;
  JobRunnerOptions runner_options() const;
  Maintenance::Options maintenance() const;
  /// How long jobs that run may go on after SIGTERM: what they leave of --drain suffices to hand
  /// them back, and to end calls.
  std::chrono::milliseconds drain_of_jobs() const;
};

/// Also checks that either workers or all split stages are given.
void AddCoordinatorFlags(CLI::App& app, CoordinatorFlags* flags);

}  // namespace slicefarm::coordinator
