#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "common/stage/memory_budget.h"
#include "services/coordinator/remote/remote_projects.h"
#include "services/coordinator/server/api/jobs_service.h"
#include "services/coordinator/server/api/meshes_service.h"
#include "services/coordinator/server/api/preset_library.h"
#include "services/coordinator/server/api/presets_service.h"
#include "services/coordinator/server/api/profiles_service.h"
#include "services/coordinator/server/execution/maintenance.h"
#include "services/coordinator/server/main/stores.h"
#include "services/coordinator/server/observe/metered_blob_store.h"
#include "services/coordinator/server/observe/metered_job_store.h"
#include "services/coordinator/server/observe/stage_seconds.h"
#include "services/coordinator/server/webhooks/webhook_sender.h"

namespace slicefarm::coordinator {

/// Options of a Coordinator.
struct CoordinatorOptions {
  StoreOptions stores;
  /// Directory for the programs of running jobs until they are assembled. If empty, a directory
  /// beside the state is used, or the system's directory for temporary files if there is no state
  /// directory.
  std::string spool_dir = {};
  JobRunnerOptions runner;
  Rates rates = {};
  /// Profile of jobs that name no printer, for tenants without a default of their own.
  std::string default_profile = {};
  WebhooksNow webhooks = [none = std::make_shared<const WebhookPolicy>()] { return none; };
  WebhookSender::Options webhook_sender = {};
  int64_t memory_bytes = DefaultMemoryBudget();  ///< memory that all jobs together may use
  /// Free bytes of the disk with stores.state_dir below which new data is refused; 0: no check.
  int64_t min_free_bytes = 0;
  /// Largest size of the database stores.postgres; 0: no limit.
  int64_t max_database_bytes = 0;
  std::string build_id;
  /// Returns true if the stages that jobs of a process need are reachable and of this build. Called
  /// after a run of the process has met another stage.
  std::function<bool(Process)> stages_fit = [](Process) { return true; };
  /// Returns the names of stages that jobs of a process need and that have no reachable server.
  std::function<std::vector<std::string>(Process)> away_stages = [](Process) {
    return std::vector<std::string>();
  };
  TransferOptions transfers = {};
  WatchOptions watches = {};
  CallLimits calls = {};
  Maintenance::Options maintenance = {};
  /// function that returns the current tenants; empty: one tenant without a name
  TenantsNow tenants = {};
  ResultSharing sharing = ResultSharing::kOff;
  /// Registry of the metrics; null: no metrics are exported. Must outlive the coordinator.
  prometheus::Registry* metrics = nullptr;
};

/// Stages that the coordinator calls itself, at least slicing. The executor calls the stages of
/// tasks. They must outlive the coordinator.
struct JobStages {
  /// stages; the coordinator supports each process that has all its stages in this set
  Stages stages;
  const ArrangingStage& arranging;
  const ProjectReader& projects;
};

/// Assembled coordinator: stores, intake, runner and services on the given stages. Several
/// coordinators may share one PostgreSQL database; all of them are active.
class Coordinator {
 public:
  /// Opens the stores and creates a coordinator. The stages and the executor must outlive it.
  /// Errors: see OpenStores.
  static absl::StatusOr<std::unique_ptr<Coordinator>> Open(CoordinatorOptions options,
                                                           const JobStages& stages,
                                                           TaskExecutor& executor,
                                                           const rpc::JsonLog& log);
  ~Coordinator();

  /// Begins to run jobs, first the jobs that this coordinator left when it last ended.
  absl::Status Start();

  /// Stops claiming jobs, and waits until the running jobs have ended, for at most `patience`.
  /// Calls are answered meanwhile.
  void Drain(std::chrono::milliseconds patience) { runner_.Drain(patience); }

  /// Puts the running jobs back into the queue, and ends the calls that watch jobs.
  void Stop();

  /// Returns the gRPC services of the coordinator.
  std::vector<grpc::Service*> services() {
    return {&meshes_service_, &jobs_service_, &profiles_service_, &presets_service_};
  }
  /// Returns the methods that are served from a completion queue.
  rpc::QueuedMethods& queued_methods() { return jobs_service_; }
  /// Returns the object that authenticates callers.
  const Callers& callers() const { return callers_; }
  /// Returns the job store for callers.
  JobStore& jobs() { return jobs_; }
  /// Returns the feed with the news of jobs.
  const JobFeed& feed() const { return feed_; }
  /// Returns the function that measures the shared database; an empty function if there is none.
  const std::function<absl::StatusOr<DatabaseFill>()>& database_fill() const {
    return stores_.fill;
  }
  /// Returns the presets of jobs.
  const PresetLibrary& presets() const { return presets_; }
  /// Returns false if the shared database has not answered for seconds, so that calls fail.
  bool store_answers() const { return !stores_.answers || stores_.answers(); }

 private:
  Coordinator(CoordinatorOptions options, Stores stores, const JobStages& stages,
              TaskExecutor& executor, const rpc::JsonLog& log);
  void Changed(const std::optional<JobChange>& change);
  void PublishProgress(const std::stop_token& stop);
  prometheus::Registry& Registry();
  DiskGuard Guard() const;
  bool RunsHaveSpace() const;

  const CoordinatorOptions options_;
  const Stores stores_;
  const rpc::JsonLog log_;
  prometheus::Registry unseen_metrics_;
  MeteredJobStore jobs_;
  MeteredJobStore runs_;
  MeteredBlobStores blobs_;
  MeteredBlobStores run_blobs_;
  StageSeconds stage_seconds_;
  JobPipeline pipeline_;
  MemoryBudget memory_;
  ResolvedJobs resolved_;
  JobResults results_;
  JobFeed feed_;
  const DiskGuard disk_;
  TenantBudgets budgets_;
  FullQueues full_queues_;
  const Callers callers_;
  JobIntake intake_;
  JobRunner runner_;
  PresetLibrary presets_;
  MeshesService meshes_service_;
  JobsService jobs_service_;
  ProfilesService profiles_service_;
  PresetsService presets_service_;
  std::unique_ptr<JobChanges> changes_;
  std::jthread progress_;  ///< sends the progress to other coordinators, if there are any
  std::optional<WebhookSender> webhook_sender_;
  std::optional<Maintenance> maintenance_;
};

}  // namespace slicefarm::coordinator
