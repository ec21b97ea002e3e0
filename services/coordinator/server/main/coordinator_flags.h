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

/// Options of slicefarm-coordinator. Addresses are host:port, separated by commas; each name may
/// have any number of replicas.
struct CoordinatorFlags {
  rpc::ServeFlags serve;
  StoreOptions stores;  ///< without the bucket, which is in `s3`
  S3Flags s3;
  std::string spool_dir;  ///< if empty, the default of CoordinatorOptions::spool_dir applies
  /// Addresses by stage, for stages that are services. Check reports missing addresses.
  std::map<Stage, std::string> stages;
  /// Addresses of workers that run all stages of layers. If empty, these stages are services.
  std::string workers;
  int split_slots = 8;  ///< number of ranges in flight at the separate services of the layer stages
  JobRunnerOptions runner;
  std::string rates_file;
  std::string default_profile;
  std::string webhooks_file;
  /// file of tenants (tenants.h); empty: one tenant, to which all callers belong
  std::string tenants_file;
  bool share_cache = false;
  int64_t min_free_mib = 1024;
  int64_t max_database_gib = 0;
  int64_t memory_mib = DefaultMemoryBudget() >> 20;
  double lease_s = 10;
  double keep_jobs_days = 0;
  double keep_blobs_hours = 24;
  double sweep_after_hours = 24;

  /// Returns true if the stages of layers are separate services, not parts of workers.
  bool split() const { return Has(Stage::kBeading); }
  /// Returns true if the stage has addresses.
  bool Has(Stage stage) const { return stages.contains(stage) && !stages.at(stage).empty(); }
  /// Returns the addresses of each stage as a list.
  std::map<Stage, std::vector<std::string>> stage_names() const;
  /// Returns the options of the runner.
  JobRunnerOptions runner_options() const;
  /// Returns the options of the maintenance.
  Maintenance::Options maintenance() const;
  /// Returns the time that running jobs may continue after SIGTERM. It is shorter than --drain, so
  /// that time remains to return the jobs to the queue and to end calls.
  std::chrono::milliseconds drain_of_jobs() const;
};

/// Adds the options to `app`. Parsing also checks that either workers or all split stages are
/// given.
void AddCoordinatorFlags(CLI::App& app, CoordinatorFlags* flags);

}  // namespace slicefarm::coordinator
