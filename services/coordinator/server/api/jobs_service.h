#pragma once

#include <functional>
#include <optional>

#include "common/rpc/observe/json_log.h"
#include "common/rpc/server/call_gate.h"
#include "common/rpc/server/call_queue.h"
#include "common/stage/memory_budget.h"
#include "common/stage/plates.h"
#include "services/coordinator/algo/pipeline/cost.h"
#include "services/coordinator/server/api/callers.h"
#include "services/coordinator/server/api/job_intake.h"
#include "services/coordinator/server/api/job_watch.h"
#include "services/coordinator/server/api/plate_submissions.h"
#include "services/coordinator/server/api/transfers.h"
#include "services/coordinator/server/execution/job_feed.h"
#include "services/coordinator/server/execution/job_runner.h"
#include "services/coordinator/server/webhooks/webhook_policy.h"
#include "services/coordinator/store/jobs/profile_store.h"
#include "services/coordinator/store/jobs/webhook_store.h"
#include "slicefarm/v1/jobs.grpc.pb.h"

namespace slicefarm::coordinator {

/// What the service speaks for. Everything outlives it.
struct JobsBackend {
  const Callers& callers;
  JobStore& jobs;
  BlobStores& blobs;
  JobIntake& intake;
  JobRunner& runner;
  JobFeed& feed;
  ProfileStore& profiles;
  WebhookStore& webhooks;
  const WebhooksNow& webhook_policy;
  const SlicingStage& slicing;  ///< for preflights
  const ArrangingStage& arranging;
  const PlanningStage& planning;  ///< for preflights
  MemoryBudget& memory;
  Rates rates;
  std::function<int64_t()> now_us;
  rpc::JsonLog log;
};

/// Translates slicefarm.v1.Jobs. A job of another tenant is, to its callers, one that does not
/// exist.
class JobsService final : public JobWatches::Service, public rpc::QueuedMethods {
 public:
  JobsService(JobsBackend backend, const TransferOptions& transfers, const WatchOptions& watches)
      : backend_(std::move(backend)),
        downloads_(transfers),
        preflights_({.slots = 2, .queue = 16}, backend_.log),
        preflights_of_tenants_(/*all=*/18, /*of_each=*/6),
        lists_of_tenants_(/*all=*/32, /*of_each=*/4),
        watches_of_tenants_(watches.calls, watches.calls_a_tenant) {}

  grpc::Status CreateJob(grpc::ServerContext* context, const v1::CreateJobRequest* request,
                         v1::Job* response) override;
  grpc::Status BatchCreateJobs(grpc::ServerContext* context,
                               const v1::BatchCreateJobsRequest* request,
                               v1::BatchCreateJobsResponse* response) override;
  grpc::Status CreatePlates(grpc::ServerContext* context, const v1::CreatePlatesRequest* request,
                            v1::CreatePlatesResponse* response) override;
  grpc::Status GetJob(grpc::ServerContext* context, const v1::GetJobRequest* request,
                      v1::Job* response) override;
  grpc::Status ListJobs(grpc::ServerContext* context, const v1::ListJobsRequest* request,
                        v1::ListJobsResponse* response) override;
  grpc::Status CancelJob(grpc::ServerContext* context, const v1::CancelJobRequest* request,
                         v1::Job* response) override;
  grpc::Status DeleteJob(grpc::ServerContext* context, const v1::DeleteJobRequest* request,
                         google::protobuf::Empty* response) override;
  grpc::Status GetWebhook(grpc::ServerContext* context, const v1::GetWebhookRequest* request,
                          v1::Webhook* response) override;
  grpc::Status Download(grpc::ServerContext* context, const v1::DownloadRequest* request,
                        grpc::ServerWriter<v1::DownloadResponse>* stream) override;
  void ServeFrom(grpc::ServerCompletionQueue& queue) override;  // WatchJob

 private:
  enum class Of { kTenant, kAllForAdmins };
  absl::StatusOr<JobRecord> Find(const Caller& caller, const std::string& id, Of of);
  absl::StatusOr<JobRecord> Find(const grpc::ServerContextBase& context, const Scopes& one_of,
                                 const std::string& id, Of of);
  absl::StatusOr<Submission> Read(const Caller& caller, const v1::CreateJobRequest& request);
  absl::StatusOr<JobRecord> Create(const Caller& caller, const v1::CreateJobRequest& request,
                                   const TraceContext& trace);
  absl::StatusOr<rpc::Admission::Ticket> AdmitWatch(const grpc::ServerContext& context,
                                                    const v1::WatchJobRequest& request);
  absl::StatusOr<v1::Job> Validate(const Submission& submission,
                                   const v1::CreateJobRequest& request, const rpc::Call& call);
  absl::StatusOr<std::vector<v1::Job>> MakePlates(const Caller& caller,
                                                  const v1::CreatePlatesRequest& request,
                                                  const rpc::Call& call);
  absl::StatusOr<std::vector<Submission>> ReadPlates(const Caller& caller,
                                                     const v1::CreateJobRequest& request,
                                                     const PlateRoom& room, const rpc::Call& call);
  absl::StatusOr<std::vector<JobRecord>> CreateAll(std::vector<Submission> plates);
  /// To be read from `offset` on.
  absl::StatusOr<std::unique_ptr<BlobReader>> OpenResult(const JobRecord& job,
                                                         v1::Artifact artifact, int64_t offset);
  absl::StatusOr<std::unique_ptr<BlobReader>> OpenTrace(const JobRecord& job);
  absl::StatusOr<std::unique_ptr<BlobReader>> OpenArtifact(const Caller& caller,
                                                           const v1::DownloadRequest& request);
  absl::Status Send(const Caller& caller, const v1::DownloadRequest& request,
                    const Transfers::Moved& moved,
                    grpc::ServerWriter<v1::DownloadResponse>& stream);

  JobsBackend backend_;
  Transfers downloads_;
  rpc::CallGate preflights_;  ///< which take as long as slicing does
  TenantPlaces preflights_of_tenants_;
  TenantPlaces lists_of_tenants_;
  TenantPlaces watches_of_tenants_;
  std::optional<JobWatches> watches_;
};

}  // namespace slicefarm::coordinator
