#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string_view>

#include "common/rpc/observe/json_log.h"
#include "common/rpc/server/call_limiter.h"
#include "common/rpc/server/call_queue.h"
#include "common/stage/memory_budget.h"
#include "common/stage/plates.h"
#include "services/coordinator/algo/pipeline/cost.h"
#include "services/coordinator/algo/pipeline/preflight.h"
#include "services/coordinator/server/api/callers.h"
#include "services/coordinator/server/api/derived_facts.h"
#include "services/coordinator/server/api/job_intake.h"
#include "services/coordinator/server/api/job_watch.h"
#include "services/coordinator/server/api/plate_submissions.h"
#include "services/coordinator/server/api/preset_library.h"
#include "services/coordinator/server/api/queue_view.h"
#include "services/coordinator/server/api/tenant_slot_queue.h"
#include "services/coordinator/server/api/tenant_watch.h"
#include "services/coordinator/server/api/transfers.h"
#include "services/coordinator/server/api/watch_reads.h"
#include "services/coordinator/server/execution/job_feed.h"
#include "services/coordinator/server/execution/job_runner.h"
#include "services/coordinator/server/webhooks/webhook_policy.h"
#include "services/coordinator/store/jobs/profile_store.h"
#include "services/coordinator/store/jobs/webhook_store.h"
#include "slicefarm/v1/jobs.grpc.pb.h"

namespace slicefarm::coordinator {

/// Objects that the service uses. All of them must outlive it.
struct JobsBackend {
  const Callers& callers;
  JobStore& jobs;
  BlobStores& blobs;
  JobIntake& intake;
  JobRunner& runner;
  JobFeed& feed;
  ProfileStore& profiles;
  ProfileStore& preset_bundles;
  PresetLibrary& presets;
  WebhookStore& webhooks;
  const WebhooksNow& webhook_policy;
  const SlicingStage& slicing;  ///< for preflights
  const ArrangingStage& arranging;
  const JobPipeline& pipeline;  ///< for preflights
  MemoryBudget& memory;
  Rates rates;
  /// Profile of jobs that name no printer; if empty, jobs must name one.
  std::string default_profile;
  /// Returns the names of stages that jobs of a process need and that have no reachable server.
  std::function<std::vector<std::string>(Process)> away_stages;
  /// Clock of the coordinator, in us.
  std::function<int64_t()> now_us;
  rpc::JsonLog log;
};

/// Implements slicefarm.v1.Jobs. If a caller names a job of another tenant, the answer is the same
/// as for a job that does not exist.
class JobsService final : public JobWatches::Service, public rpc::QueuedMethods {
 public:
  JobsService(JobsBackend backend, const TransferOptions& transfers, const WatchOptions& watches)
      : backend_(std::move(backend)),
        downloads_(transfers),
        preflights_({.slots = kPreflightCalls, .longest = kLongestPreflight}, backend_.log),
        preflights_of_tenants_(kPreflightCalls),
        preflight_slots_(kPreflightSlots),
        lists_of_tenants_(kLists),
        watches_of_tenants_(watches.calls),
        watches_of_all_jobs_(kTenantWatches),
        watch_reads_(backend_.jobs, kWatchReaders),
        queue_(backend_.jobs, backend_.now_us) {}

  grpc::Status CreateJob(grpc::ServerContext* context, const v1::CreateJobRequest* request,
                         v1::Job* response) override;
  grpc::Status BatchCreateJobs(grpc::ServerContext* context,
                               const v1::BatchCreateJobsRequest* request,
                               v1::BatchCreateJobsResponse* response) override;
  grpc::Status CreatePlates(grpc::ServerContext* context, const v1::CreatePlatesRequest* request,
                            v1::CreatePlatesResponse* response) override;
  grpc::Status GetJob(grpc::ServerContext* context, const v1::GetJobRequest* request,
                      v1::Job* response) override;
  grpc::Status BatchGetJobs(grpc::ServerContext* context, const v1::BatchGetJobsRequest* request,
                            v1::BatchGetJobsResponse* response) override;
  grpc::Status ListJobs(grpc::ServerContext* context, const v1::ListJobsRequest* request,
                        v1::ListJobsResponse* response) override;
  grpc::Status CancelJob(grpc::ServerContext* context, const v1::CancelJobRequest* request,
                         v1::Job* response) override;
  grpc::Status BatchCancelJobs(grpc::ServerContext* context,
                               const v1::BatchCancelJobsRequest* request,
                               v1::BatchCancelJobsResponse* response) override;
  grpc::Status UpdateJob(grpc::ServerContext* context, const v1::UpdateJobRequest* request,
                         v1::Job* response) override;
  grpc::Status ListArtifacts(grpc::ServerContext* context, const v1::ListArtifactsRequest* request,
                             v1::ListArtifactsResponse* response) override;
  grpc::Status GetCaller(grpc::ServerContext* context, const v1::GetCallerRequest* request,
                         v1::GetCallerResponse* response) override;
  grpc::Status GetUsage(grpc::ServerContext* context, const v1::GetUsageRequest* request,
                        v1::Usage* response) override;
  grpc::Status ListSettings(grpc::ServerContext* context, const v1::ListSettingsRequest* request,
                            v1::ListSettingsResponse* response) override;
  grpc::Status ExportTenant(grpc::ServerContext* context, const v1::ExportTenantRequest* request,
                            grpc::ServerWriter<v1::DownloadResponse>* stream) override;
  grpc::Status EraseTenant(grpc::ServerContext* context, const v1::EraseTenantRequest* request,
                           v1::EraseTenantResponse* response) override;
  grpc::Status WatchJobs(grpc::ServerContext* context, const v1::WatchJobsRequest* request,
                         grpc::ServerWriter<v1::WatchJobsResponse>* stream) override;
  grpc::Status DeleteJob(grpc::ServerContext* context, const v1::DeleteJobRequest* request,
                         google::protobuf::Empty* response) override;
  grpc::Status GetWebhook(grpc::ServerContext* context, const v1::GetWebhookRequest* request,
                          v1::Webhook* response) override;
  grpc::Status Download(grpc::ServerContext* context, const v1::DownloadRequest* request,
                        grpc::ServerWriter<v1::DownloadResponse>* stream) override;
  void ServeFrom(grpc::ServerCompletionQueue& queue) override;  // WatchJob

  /// Ends all reads for watches. REQUIRES: the feed has ended the watches; the server still runs.
  void EndWatches() { watch_reads_.Stop(); }

 private:
  static constexpr int kPreflightCalls = 24;  ///< largest number of preflights that run or wait
  static constexpr int kPreflightSlots = 4;
  /// Time limit of a preflight. Longer work must be submitted as a job.
  static constexpr std::chrono::minutes kLongestPreflight{10};
  static constexpr int kLists = 32;
  /// Number of threads that read events for watches. Each one uses one of the at most 8 connections
  /// of the store.
  static constexpr int kWatchReaders = 2;

  enum class Of { kTenant, kAllForAdmins };
  absl::StatusOr<JobRecord> Find(const Caller& caller, const std::string& id, Of of);
  absl::StatusOr<JobRecord> Find(const grpc::ServerContextBase& context, const Scopes& one_of,
                                 const std::string& id, Of of);
  v1::Job Describe(JobRecord job);
  absl::StatusOr<JobRecord> Cancel(const Caller& caller, const std::string& id);
  absl::StatusOr<Submission> Read(const Caller& caller, const v1::CreateJobRequest& request);
  absl::StatusOr<JobRecord> Create(const Caller& caller, const v1::CreateJobRequest& request,
                                   const grpc::ServerContext& context);
  grpc::Status Preflight(const grpc::ServerContext& context, const Caller& caller,
                         std::string_view method,
                         const std::function<absl::Status(const rpc::Call& call)>& work);
  absl::StatusOr<Watcher> AdmitWatch(const grpc::ServerContext& context);
  absl::StatusOr<v1::Job> Validate(const Submission& submission,
                                   const v1::CreateJobRequest& request, const rpc::Call& call);
  absl::StatusOr<std::vector<v1::Job>> MakePlates(const Caller& caller,
                                                  const v1::CreatePlatesRequest& request,
                                                  const rpc::Call& call);
  absl::StatusOr<std::vector<Plate>> ReadPlates(const Caller& caller,
                                                const v1::CreatePlatesRequest& request,
                                                const rpc::Call& call);
  absl::StatusOr<std::vector<v1::Job>> ValidateAll(const std::vector<Plate>& plates,
                                                   const v1::CreatePlatesRequest& request,
                                                   const rpc::Call& call);
  absl::StatusOr<std::vector<JobRecord>> CreateAll(std::vector<Submission> plates,
                                                   const CancelToken& cancel);
  /// Opens an artifact for reading from `offset` on.
  absl::StatusOr<std::unique_ptr<BlobReader>> OpenResult(const JobRecord& job,
                                                         v1::Artifact artifact, int64_t offset);
  absl::StatusOr<std::unique_ptr<BlobReader>> OpenTrace(const JobRecord& job);
  absl::StatusOr<std::unique_ptr<BlobReader>> OpenDerived(const JobRecord& job,
                                                          v1::Artifact artifact);
  absl::StatusOr<std::unique_ptr<BlobReader>> OpenArtifact(const Caller& caller,
                                                           const v1::DownloadRequest& request);
  absl::Status Send(const Caller& caller, const v1::DownloadRequest& request,
                    const Transfers::Moved& moved,
                    grpc::ServerWriter<v1::DownloadResponse>& stream);

  JobsBackend backend_;
  Transfers downloads_;
  rpc::CallLimiter preflights_;  ///< limits preflights, which take as long as slicing
  TenantSlots preflights_of_tenants_;
  TenantSlotQueue preflight_slots_;
  TenantSlots lists_of_tenants_;
  DerivedFacts derived_facts_;
  TenantSlots watches_of_tenants_;
  TenantSlots watches_of_all_jobs_;
  WatchReads watch_reads_;
  QueueView queue_;
  std::optional<JobWatches> watches_;
};

}  // namespace slicefarm::coordinator
