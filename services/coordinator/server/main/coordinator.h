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
#include "services/coordinator/server/api/profiles_service.h"
#include "services/coordinator/server/execution/maintenance.h"
#include "services/coordinator/server/main/stores.h"
#include "services/coordinator/server/observe/metered_blob_store.h"
#include "services/coordinator/server/observe/metered_job_store.h"
#include "services/coordinator/server/observe/stage_seconds.h"
#include "services/coordinator/server/webhooks/webhook_sender.h"

namespace slicefarm::coordinator {

struct CoordinatorOptions {
  StoreOptions stores;
  /// Where the programs of running jobs wait to be put together; empty: with the state in a
  /// directory, or where the system has temporary files.
  std::string spool_dir = {};
  JobRunnerOptions runner;
  Rates rates = {};
  std::string default_profile = {};  ///< of jobs that name no printer, of tenants without their own
  WebhooksNow webhooks = [none = std::make_shared<const WebhookPolicy>()] { return none; };
  WebhookSender::Options webhook_sender = {};
  int64_t memory_bytes = DefaultMemoryBudget();  ///< that all jobs may hold together
  int64_t min_free_bytes = 0;                    ///< of the disk of stores.state_dir
  int64_t max_database_bytes = 0;                ///< of stores.postgres; 0: any number
  std::string build_id;
  /// Whether the stages that all jobs need are of this build, asked after a run that met others.
  std::function<bool()> stages_fit = [] { return true; };
  TransferOptions transfers = {};
  WatchOptions watches = {};
  CallLimits calls = {};
  Maintenance::Options maintenance = {};
  TenantsNow tenants = {};  ///< none: one tenant without a name
  ResultSharing sharing = ResultSharing::kOff;
  prometheus::Registry* metrics = nullptr;  ///< outlives the coordinator; null: nobody looks
};

/// The stages that jobs go through, besides those of their tasks: slicing at least. They outlive
/// the coordinator.
struct JobStages {
  Stages stages;  ///< jobs are made of processes whose stages are there
  const ArrangingStage& arranging;
  const ProjectReader& projects;
};

/// The coordinator put together: stores, intake, runner and services over given stages. Several may
/// share one PostgreSQL database; all of them are active.
class Coordinator {
 public:
  /// The stages and the executor must outlive it. Errors: those of the stores; Unavailable if
  /// another process uses the directory.
  static absl::StatusOr<std::unique_ptr<Coordinator>> Open(CoordinatorOptions options,
                                                           const JobStages& stages,
                                                           TaskExecutor& executor,
                                                           const rpc::JsonLog& log);
  ~Coordinator();

  /// Begins to run jobs, those of an earlier life first.
  absl::Status Start();

  /// Takes up no job any more, and waits until those that run have ended, `patience` at most. Calls
  /// are answered meanwhile.
  void Drain(std::chrono::milliseconds patience) { runner_.Drain(patience); }

  /// Hands running jobs back, and ends the calls that watch.
  void Stop();

  std::vector<grpc::Service*> services() {
    return {&meshes_service_, &jobs_service_, &profiles_service_};
  }
  rpc::QueuedMethods& queued_methods() { return jobs_service_; }
  const Callers& callers() const { return callers_; }
  JobStore& jobs() { return jobs_; }
  const JobFeed& feed() const { return feed_; }
  /// Of the database that it shares with others; or null.
  const std::function<absl::StatusOr<DatabaseFill>()>& database_fill() const {
    return stores_.fill;
  }
  /// False: the database that it shares has been silent for seconds, so that calls fail.
  bool store_answers() const { return !stores_.answers || stores_.answers(); }

 private:
  Coordinator(CoordinatorOptions options, Stores stores, const JobStages& stages,
              TaskExecutor& executor, const rpc::JsonLog& log);
  void Changed(const std::optional<JobChange>& change);
  void TellProgress(const std::stop_token& stop);
  prometheus::Registry& Registry();
  DiskGuard Guard() const;
  bool RunsHaveRoom() const;

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
  MeshesService meshes_service_;
  JobsService jobs_service_;
  ProfilesService profiles_service_;
  std::unique_ptr<JobChanges> changes_;
  std::jthread telling_;  ///< of progress, if others listen
  std::optional<WebhookSender> webhook_sender_;
  std::optional<Maintenance> maintenance_;
};

}  // namespace slicefarm::coordinator
